"""CORBA stubs: generated Python, the .idl files that it comes from, and the one command that makes it (generate.py).

component   SDOPackage, RTC, OpenRTM   components, ports, execution contexts, configuration
manager     RTM                        managers
dataport    OpenRTM, RTC               being a data port: corba_cdr, data_service
observer    OpenRTM, RTC               observers and loggers that a component calls back
fsm         RTC                        state machine components
data        RTC, Img                   what travels over data ports

Take a module from its package: `from rtshell_lite.idl_stubs.component import RTC`. Who serves objects derives them from
`corba.stubs.skeleton("component.RTC.PortService")`. One IDL module may live in several packages (RTC in four of them), so
that a command loads only what it needs; no two of them share a name.
"""
