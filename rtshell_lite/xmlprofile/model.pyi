from typing import List, Optional

from rtshell_lite.xmlprofile.fields import Element

class Property(Element):
    name: str
    value: Optional[str]

class TargetComponent(Element):
    component_id: str
    instance_name: str
    properties: List[Property]

class TargetPort(Element):
    component_id: str
    instance_name: str
    port_name: str
    properties: List[Property]

class TargetExecutionContext(Element):
    component_id: str
    instance_name: str
    id: str
    properties: List[Property]

class DataPort(Element):
    name: str
    comment: str
    visible: bool
    properties: List[Property]

class ServicePort(Element):
    name: str
    comment: str
    visible: bool
    properties: List[Property]

class ConfigurationData(Element):
    name: str
    data: str

class ConfigurationSet(Element):
    id: str
    configuration_data: List[ConfigurationData]

class ExecutionContext(Element):
    id: str
    kind: str
    rate: float
    participants: List[TargetComponent]
    properties: List[Property]

class Participant(Element):
    component: Optional[TargetComponent]

class Location(Element):
    x: int
    y: int
    height: int
    width: int
    direction: str

class Component(Element):
    id: str
    path_uri: str
    active_configuration_set: str
    instance_name: str
    composite_type: str
    is_required: bool
    comment: str
    visible: bool
    data_ports: List[DataPort]
    service_ports: List[ServicePort]
    configuration_sets: List[ConfigurationSet]
    execution_contexts: List[ExecutionContext]
    participants: List[Participant]
    location: Optional[Location]
    properties: List[Property]

class Group(Element):
    group_id: str
    members: List[TargetComponent]

class Connector(Element):
    @property
    def ends(self) -> List[TargetPort]: ...
    @ends.setter
    def ends(self, ports: List[TargetPort]) -> None: ...

class DataPortConnector(Connector):
    connector_id: str
    name: str
    data_type: str
    interface_type: str
    dataflow_type: str
    subscription_type: str
    push_interval: float
    comment: str
    visible: bool
    source: Optional[TargetPort]
    target: Optional[TargetPort]
    further_ends: List[TargetPort]
    properties: List[Property]

class ServicePortConnector(Connector):
    connector_id: str
    name: str
    trans_method: str
    comment: str
    visible: bool
    source: Optional[TargetPort]
    target: Optional[TargetPort]
    further_ends: List[TargetPort]
    properties: List[Property]

class WaitTime(Element):
    wait_time: int

class Preceding(Element):
    timeout: int
    sending_timing: str
    preceding_components: List[TargetExecutionContext]

class Condition(Element):
    sequence: int
    wait_time: Optional[WaitTime]
    preceding: Optional[Preceding]
    target: Optional[TargetExecutionContext]
    properties: List[Property]

class MessageSending(Element):
    targets: List[Condition]

class System(Element):
    path: str

class RtsProfile(Element):
    id: str
    abstract: str
    creation_date: str
    update_date: str
    version: str
    comment: str
    components: List[Component]
    groups: List[Group]
    data_port_connectors: List[DataPortConnector]
    service_port_connectors: List[ServicePortConnector]
    one_port_connectors: List[DataPortConnector]
    start_up: Optional[MessageSending]
    shut_down: Optional[MessageSending]
    activation: Optional[MessageSending]
    deactivation: Optional[MessageSending]
    resetting: Optional[MessageSending]
    initializing: Optional[MessageSending]
    finalizing: Optional[MessageSending]
    version_up_logs: List[str]
    properties: List[Property]
    systems: List[System]
    @property
    def connectors(self) -> List[Connector]: ...
    def add_connector(self, connector: Connector) -> None: ...
