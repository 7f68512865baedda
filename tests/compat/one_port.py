"""A transport for Python components of OpenRTM-aist that connects one port alone, as those of ROS and DDS do.

A component loads it itself: manager.modules.preload. It carries nothing: what is written is counted.
"""
import OpenRTM_aist

NAME = "ssm"


class Sends(OpenRTM_aist.InPortConsumer):
    """The end of an out port."""

    def __init__(self):
        OpenRTM_aist.InPortConsumer.__init__(self)
        self.count = 0

    def init(self, prop):
        pass

    def put(self, data):
        self.count += 1
        return self.PORT_OK

    def publishInterfaceProfile(self, properties):
        pass

    def subscribeInterface(self, properties):
        return True

    def unsubscribeInterface(self, properties):
        pass


class Receives(OpenRTM_aist.InPortProvider):
    """The end of an in port, at which nothing arrives."""

    def __init__(self):
        OpenRTM_aist.InPortProvider.__init__(self)
        self.setInterfaceType(NAME)

    def init(self, prop):
        pass

    def setBuffer(self, buffer):
        pass

    def setListener(self, info, listeners):
        pass


def one_portInit(manager):
    """Called by the manager that loads this."""
    OpenRTM_aist.InPortConsumerFactory.instance().addFactory(NAME, Sends)
    OpenRTM_aist.InPortProviderFactory.instance().addFactory(NAME, Receives)
