"""What an RtsProfile says about a system: components, connections, the order of starting and stopping.

FIELDS of a class is its whole schema, by which both file forms are read and written.

    Component(id="RTC:Acme:nav:Planner:2.0", path_uri="localhost/Planner0.rtc", instance_name="Planner0")

A field that is not given has its default. `foreign` holds what is not in the schema.
"""

from rtshell_lite.xmlprofile.fields import (
    BOOLEAN, DATE, INTEGER, NUMBER, TEXT, Child, Children, Element, Field
)

# Files spell these in any case, version 0.1 has other names, and rtsprofile misspells one.
COMPOSITE_TYPES = {
    name.lower(): name
    for name in (
        "None", "PeriodicECShared", "PeriodicStateShared", "Grouping", "FsmECShared", "FsmStateShared"
    )
}
COMPOSITE_TYPES.update(
    choice="None", ecshared="PeriodicECShared", allshared="PeriodicStateShared", nonshared="Grouping"
)
DIRECTIONS = {name.lower(): name for name in ("DOWN", "RIGHT", "UP", "LEFT")}


# ---- what elements share ----


class Property(Element):
    FIELDS = (
        Field("name", "rtsExt:name", required=True, always=True, key="name"),
        Field(
            "value", "rtsExt:value", default=None, key="value"
        ),  # many files have properties without values
    )


PROPERTIES = Children("properties", "rtsExt:Properties", Property)
COMMENT = Field("comment", "rtsExt:comment")
VISIBLE = Field("visible", "rtsExt:visible", BOOLEAN, True)
VISIBLE_ALWAYS = Field("visible", "rtsExt:visible", BOOLEAN, True, always=True)


class TargetComponent(Element):
    """Names a component of the profile, from elsewhere in it."""

    XSI_TYPE = "rtsExt:target_component_ext"
    FIELDS = (
        Field("component_id", "rts:componentId", required=True, always=True),
        Field("instance_name", "rts:instanceName", required=True, always=True),
        PROPERTIES,
    )


class TargetPort(Element):
    XSI_TYPE = "rtsExt:target_port_ext"
    FIELDS = TargetComponent.FIELDS[:2] + (
        Field("port_name", "rts:portName", required=True, always=True),  # INSTANCE.port, or the port alone
        PROPERTIES,
    )


class TargetExecutionContext(Element):
    FIELDS = TargetComponent.FIELDS[:2] + (
        Field("id", "rts:id", always=True),  # RTSystemEditor leaves it out
        PROPERTIES,
    )


# ---- components ----


class DataPort(Element):
    XSI_TYPE = "rtsExt:dataport_ext"
    FIELDS = (Field("name", "rts:name", required=True, always=True), COMMENT, VISIBLE_ALWAYS, PROPERTIES)


class ServicePort(Element):
    XSI_TYPE = "rtsExt:serviceport_ext"
    FIELDS = (Field("name", "rts:name", required=True, always=True), COMMENT, VISIBLE, PROPERTIES)


class ConfigurationData(Element):
    FIELDS = (Field("name", "rts:name", required=True, always=True), Field("data", "rts:data"))


class ConfigurationSet(Element):
    FIELDS = (
        Field("id", "rts:id", required=True, always=True),
        Children("configuration_data", "rts:ConfigurationData", ConfigurationData),
    )


class ExecutionContext(Element):
    XSI_TYPE = "rtsExt:execution_context_ext"
    FIELDS = (
        Field("id", "rts:id", always=True),  # version 0.1 has none
        Field("kind", "rts:kind", always=True),
        Field("rate", "rts:rate", NUMBER, 0.0, always=True),
        Children("participants", "rts:Participants", TargetComponent),
        PROPERTIES,
    )


class Participant(Element):
    """A member of a composite component."""

    FIELDS = (Child("component", "rts:Participant", TargetComponent, required=True),)


class Location(Element):
    """Where a component is in a drawing of the system."""

    FIELDS = tuple(
        Field(name, "rtsExt:" + name, INTEGER, 0, always=True, key=name)
        for name in ("x", "y", "height", "width")
    ) + (
        Field(
            "direction", "rtsExt:direction", default="DOWN", always=True, choices=DIRECTIONS, key="direction"
        ),
    )


class Component(Element):
    XSI_TYPE = "rtsExt:component_ext"
    FIELDS = (
        Field("id", "rts:id", required=True, always=True),
        Field("path_uri", "rts:pathUri", required=True, always=True),
        Field("active_configuration_set", "rts:activeConfigurationSet"),
        Field("instance_name", "rts:instanceName", required=True, always=True),
        Field("composite_type", "rts:compositeType", default="None", always=True, choices=COMPOSITE_TYPES),
        Field("is_required", "rts:isRequired", BOOLEAN, False, always=True),
        COMMENT,
        VISIBLE_ALWAYS,
        Children("data_ports", "rts:DataPorts", DataPort),
        Children("service_ports", "rts:ServicePorts", ServicePort),
        Children("configuration_sets", "rts:ConfigurationSets", ConfigurationSet),
        Children("execution_contexts", "rts:ExecutionContexts", ExecutionContext),
        Children("participants", "rts:Participants", Participant),
        Child("location", "rtsExt:Location", Location),
        PROPERTIES,
    )


class Group(Element):
    FIELDS = (
        Field("group_id", "rts:groupId", required=True, always=True, also=("groupID",)),
        Children("members", "rts:Members", TargetComponent),
    )


# ---- connections ----


class Connector(Element):
    """A connection. The schema has a source and a target;
    further ends are in an element that other tools ignore.
    """

    @property
    def ends(self):
        """The ports that it connects, one or more."""
        return [end for end in (self.source, self.target) if end is not None] + self.further_ends

    @ends.setter
    def ends(self, ports):
        self.source, self.target = (list(ports[:2]) + [None, None])[:2]
        self.further_ends = list(ports[2:])

    def fault(self, given):
        why = super().fault(given)
        if not why and not self.ends:
            return "neither source nor target"
        return why


FURTHER_ENDS = Children("further_ends", "rtsExt:FurtherEnds", TargetPort)


class DataPortConnector(Connector):
    XSI_TYPE = "rtsExt:dataport_connector_ext"
    FIELDS = (
        Field("connector_id", "rts:connectorId", always=True),
        Field("name", "rts:name", always=True),
        Field("data_type", "rts:dataType", always=True),
        Field("interface_type", "rts:interfaceType", always=True),
        Field("dataflow_type", "rts:dataflowType", always=True),
        Field("subscription_type", "rts:subscriptionType"),
        Field("push_interval", "rts:pushInterval", NUMBER, 0.0),
        COMMENT,
        VISIBLE,
        Child("source", "rts:sourceDataPort", TargetPort),
        Child("target", "rts:targetDataPort", TargetPort),
        FURTHER_ENDS,
        PROPERTIES,
    )


class ServicePortConnector(Connector):
    XSI_TYPE = "rtsExt:serviceport_connector_ext"
    FIELDS = (
        Field("connector_id", "rts:connectorId", always=True),
        Field("name", "rts:name", always=True),
        Field("trans_method", "rts:transMethod"),
        COMMENT,
        VISIBLE,
        Child("source", "rts:sourceServicePort", TargetPort),
        Child("target", "rts:targetServicePort", TargetPort),
        FURTHER_ENDS,
        PROPERTIES,
    )


# ---- the order of starting and stopping ----


class WaitTime(Element):
    # milliseconds, counted as plan.py says
    FIELDS = (Field("wait_time", "rts:waitTime", INTEGER, 0, always=True),)


class Preceding(Element):
    """Wait for other components: SYNC until they are in the state,
    ASYNC until they have been asked to change.
    """

    FIELDS = (
        Field("timeout", "rts:timeout", INTEGER, 0, always=True),  # milliseconds; 0: for ever
        Field("sending_timing", "rts:sendingTiming"),  # SYNC, ASYNC, NO_SYNC; often missing
        Children(
            "preceding_components", "rts:PrecedingComponents", TargetExecutionContext,
            also=("PrecedingComponent",),
        ),
    )


class Condition(Element):
    """When to change a component's state. Without wait_time and preceding, `sequence` gives the order."""

    XSI_TYPE = "rtsExt:condition_ext"
    FIELDS = (
        Field("sequence", "rts:sequence", INTEGER, 0, always=True),
        Child("wait_time", "rts:WaitTime", WaitTime, within="condition"),
        Child("preceding", "rts:Preceding", Preceding, within="condition"),
        Child("target", "rts:TargetComponent", TargetExecutionContext, required=True),
        PROPERTIES,
    )


class MessageSending(Element):
    """A section such as Activation: conditions of components."""

    FIELDS = (Children("targets", "rts:targets", Condition),)


class System(Element):
    """A system inside the system."""

    FIELDS = (Field("path", "rtsExt:path", required=True, always=True, key="path"),)


SECTIONS = tuple(
    Child(name, "rts:" + local, MessageSending)
    for name, local in (
        ("start_up", "StartUp"),
        ("shut_down", "ShutDown"),
        ("activation", "Activation"),
        ("deactivation", "Deactivation"),
        ("resetting", "Resetting"),
        ("initializing", "Initializing"),
        ("finalizing", "Finalizing"),
    )
)


class RtsProfile(Element):
    """A whole system. Dates are text as in XML, such as 2024-03-05T14:07:09,
    perhaps with fraction and zone.
    """

    FIELDS = (
        (
            Field("id", "rts:id", always=True),
            Field("abstract", "rts:abstract", always=True),
            Field("creation_date", "rts:creationDate", DATE),
            Field("update_date", "rts:updateDate", DATE),
            Field("version", "rts:version", default="0.2", always=True),
            COMMENT,
            Children("components", "rts:Components", Component, also=("Component",)),
            Children("groups", "rts:Groups", Group),
            Children("data_port_connectors", "rts:DataPortConnectors", DataPortConnector),
            Children("service_port_connectors", "rts:ServicePortConnectors", ServicePortConnector),
            Children("one_port_connectors", "rtsExt:OnePortConnectors", DataPortConnector),
        )
        + SECTIONS
        + (
            Children("version_up_logs", "rtsExt:VersionUpLogs", TEXT, also=("VersionUpLog",)),
            PROPERTIES,
            Children("systems", "rtsExt:Systems", System),
        )
    )

    @property
    def connectors(self):
        """All connections, those of data ports first.

        The schema lets a connection have two ends. Those of one port, whose data goes by ROS, DDS or the
        like, are in an element of our own, which other tools ignore; those of one end among the others were a
        tool's, and are left out.
        """
        joining = [
            connector
            for connector in self.data_port_connectors + self.service_port_connectors
            if len(connector.ends) > 1
        ]
        return joining + [connector for connector in self.one_port_connectors if len(connector.ends) == 1]

    def add_connector(self, connector):
        """Add a connection to those of its kind."""
        if len(connector.ends) == 1:
            self.one_port_connectors.append(connector)
        elif isinstance(connector, DataPortConnector):
            self.data_port_connectors.append(connector)
        else:
            self.service_port_connectors.append(connector)
