"""A state machine component with the service of FSM4RTC."""
from . import carrier
from .idl import RTC, SDOPackage
from .rtc import Component

SERVICE = "IDL:omg.org/RTC/ExtendedFsmService:1.0"

STRUCTURE = """\
<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" name="Microwave" initial="closed">
  <state id="closed"><transition event="open" target="opened"/><transition event="start" target="cooking"/></state>
  <state id="opened"><transition event="close" target="closed"/></state>
  <state id="cooking"><transition event="stop" target="closed"/><transition event="open" target="opened"/></state>
</scxml>
"""  # noqa: E501
EVENTS = [("open", "TimedLong"), ("close", "TimedLong"), ("start", "TimedLong"), ("stop", "TimedLong")]


class Service(carrier.skeleton("RTC.ExtendedFsmService")):
    """The service of a state machine; it returns the structure that was set."""

    def __init__(self, fate):
        self.fate = fate
        self.state = "closed"
        self.structure = RTC.FsmStructure(
            "Microwave", STRUCTURE, [RTC.FsmEventProfile(*event) for event in EVENTS], []
        )

    def get_current_state(self):
        return self.state

    def get_fsm_structure(self):
        return RTC.RTC_OK, self.structure

    def set_fsm_structure(self, structure):
        if self.fate == "refuses":
            return RTC.UNSUPPORTED
        if self.fate != "keeps":
            self.structure = structure
        return RTC.RTC_OK


class StateMachine(Component):
    """A component with the service; in some flavours its process dies when it is asked for the service by id.
    """

    providers = (SERVICE,)

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.fsm = Service(self.options.fate)
        self.fsm_reference = self.process.serve(self.fsm, self.instance_name)

    def go(self, state):
        """Change the state, as an event would."""
        before = self.fsm.state
        self._tell(before, "PRE_ON_STATE_CHANGE", "PRE_ON_EXIT", "POST_ON_EXIT")
        self.fsm.state = state
        self._tell(state, "PRE_ONENTRY", "POST_ONENTRY", "POST_ON_STATE_CHNAGE", "PRE_ON_DO", "POST_ON_DO")

    def _tell(self, state, *steps):
        for step in steps:
            self.report("FSM_STATUS", f"{state} {step}")

    def get_service_profiles(self):
        return [SDOPackage.ServiceProfile(SERVICE, SERVICE, [], self.fsm_reference)]

    def get_service_profile(self, service_id):
        if service_id == SERVICE:
            return self.get_service_profiles()[0]
        return super().get_service_profile(service_id)

    def get_sdo_service(self, service_id):
        if service_id != SERVICE:
            return super().get_sdo_service(service_id)
        if self.options.fate == "dies":
            self.process.die()
        return self.fsm_reference

    def exit(self):
        self.process.withdraw(self.fsm)
        return super().exit()
