"""The modules of OpenRTM's IDL, as stubs that omniidl makes would have them."""
import types

from . import carrier


def module(*scopes):
    """The contents of IDL modules by how the repository ids of what is in them begin."""
    return types.SimpleNamespace(
        **{name: value for scope in scopes for name, value in carrier.contents(scope).items()}
    )


SDOPackage = module("IDL:org.omg/SDOPackage/")
RTC = module("IDL:omg.org/RTC/", "IDL:RTC/")
OpenRTM = module("IDL:openrtm.aist.go.jp/OpenRTM/", "IDL:OpenRTM/")
RTM = module("IDL:RTM/")
Img = module("IDL:Img/")
