"""OpenRTM's IDL: the .idl files, the tables that say the same in Python, and the command that writes these
(generate.py).

component   SDOPackage, RTC, OpenRTM   components, ports, execution contexts, configuration
manager     RTM                        managers
dataport    OpenRTM, RTC               being a data port: corba_cdr, data_service
observer    OpenRTM, RTC               observers and loggers that a component calls back
fsm         RTC                        state machine components
naming      CosNaming                  the name service
data        RTC, Img                   what travels over data ports

giop/idl.py reads the tables; only they are installed. A user's IDL files may include ours
(data/idl/included.py).
"""
