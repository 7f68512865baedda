"""The floor under a command: bare Python that imports omniORB, makes the fewest calls for the same answer,
and prints it.

    python3 floors.py FLOOR TCPPORT NAME ...      objects are bound in test.host_cxt of the name server at that port
"""  # noqa: E501

import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(ROOT)


def start(port):
    """The directory. References are made as our commands make them, by the tables: stubs take longer to
    import.
    """
    global CosNaming, idl, stubs
    from omniORB import CORBA
    import CosNaming
    from rtshell_lite.corba import stubs
    from rtshell_lite.giop import idl
    stubs.register()
    orb = CORBA.ORB_init(
        ["floor", "-ORBclientCallTimeOutPeriod", "3000", "-ORBverifyObjectExistsAndType", "0"], CORBA.ORB_ID
    )
    root = orb.string_to_object("corbaloc:iiop:1.2@127.0.0.1:%s/NameService" % port)._unchecked_narrow(
        CosNaming.NamingContext
    )
    return root.resolve([CosNaming.NameComponent("test", "host_cxt")])._unchecked_narrow(
        CosNaming.NamingContext
    )


def interface(name):
    return stubs.interface(idl.id_of(name))


def components(directory, names):
    for name in names:
        yield directory.resolve([CosNaming.NameComponent(name, "rtc")])._unchecked_narrow(
            interface("OpenRTM.DataFlowComponent")
        )


def nothing(port, names):
    pass


def listed(port, names):
    """All objects, sorted, and whether they live."""
    directory = start(port)
    bindings, _ = directory.list(10000)
    lines = []
    for binding in bindings:
        ref = directory.resolve(binding.binding_name)
        lines.append((binding.binding_name[0].id, "*" if ref._non_existent() else ""))
    for name, mark in sorted(lines):
        print(mark + name)


def figures(port, names):
    """The state and the ports of each, sorted."""
    directory = start(port)
    bindings, _ = directory.list(10000)
    names = sorted(binding.binding_name[0].id for binding in bindings)
    for each, name in zip(components(directory, names), names):
        contexts = each.get_owned_contexts() + each.get_participating_contexts()
        states = [context.get_component_state(each) for context in contexts]
        print(
            states,
            [(_kind(profile), len(profile.connector_profiles)) for profile in _port_profiles(each)],
            name,
        )


def _port_profiles(component):
    return [found.get_port_profile() for found in component.get_ports()]


def _kind(profile):
    return next(found.value.value() for found in profile.properties if found.name == "port.port_type")


def shown(port, names):
    """What rtcat shows of each without options."""
    for each in components(start(port), names):
        ports = [(_kind(profile), profile.name) for profile in _port_profiles(each)]
        contexts = each.get_owned_contexts() + each.get_participating_contexts()
        handles = [
            (each.get_context_handle(context), context.get_component_state(each)) for context in contexts
        ]
        composed = len(each.get_owned_organizations()), len(each.get_organizations())
        print(*_texts(each.get_component_profile()), handles, composed, *ports, sep="\n")


def _texts(profile):
    return (
        profile.instance_name,
        profile.category,
        profile.description,
        profile.type_name,
        profile.vendor,
        profile.version,
        len(profile.properties),
    )


def profiles(port, names):
    """The profiles of a component and its ports."""
    for each in components(start(port), names):
        ports = [found.get_port_profile() for found in each.get_ports()]
        contexts = each.get_owned_contexts(), each.get_participating_contexts()
        states = [
            (context.get_component_state(each), context.get_profile())
            for group in contexts
            for context in group
        ]
        print(
            each.get_component_profile(),
            each.get_owned_organizations(),
            each.get_organizations(),
            states,
            ports,
        )


def _change(operation, port, names):
    for each in components(start(port), names):
        contexts = each.get_owned_contexts()
        print(getattr(contexts[0], operation)(each))


def activate(port, names):
    _change("activate_component", port, names)


def deactivate(port, names):
    _change("deactivate_component", port, names)


def _ends(port, names):
    """The port `out` of the first, `in` of the second."""
    found = []
    for each, name in zip(components(start(port), names), ("out", "in")):
        for one in each.get_ports():
            if one.get_port_profile().name.endswith("." + name):
                found.append(one)
    return found


def connect(port, names):
    from omniORB import any as omniany
    ends = _ends(port, names)
    properties = [
        idl.struct("SDOPackage.NameValue")("dataport." + key, omniany.to_any(value))
        for key, value in (
            ("data_type", "IDL:RTC/TimedLong:1.0"),
            ("interface_type", "corba_cdr"),
            ("dataflow_type", "push"),
            ("subscription_type", "flush"),
        )
    ]
    print(ends[0].connect(idl.struct("RTC.ConnectorProfile")("out_in", "", ends, properties))[0])


def disconnect(port, names):
    ends = _ends(port, names)
    for connector in ends[0].get_connector_profiles():
        print(ends[0].disconnect(connector.connector_id))


def configurations(port, names):
    for each in components(start(port), names):
        found = each.get_configuration()
        print(found.get_active_configuration_set(), found.get_configuration_sets())


def contexts(port, names):
    for each in components(start(port), names):
        for context in each.get_owned_contexts() + each.get_participating_contexts():
            print(context.get_profile(), context.is_running(), context.get_component_state(each))


def manager(port, names):
    """What a manager has loaded."""
    start(port)
    from omniORB import CORBA
    root = CORBA.ORB_init([], CORBA.ORB_ID).string_to_object(
        "corbaloc:iiop:1.2@127.0.0.1:%s/NameService" % port
    )
    found = root._unchecked_narrow(CosNaming.NamingContext).resolve([
        CosNaming.NameComponent("beside", "host_cxt"), CosNaming.NameComponent("manager", "mgr")])
    print(found._unchecked_narrow(interface("RTM.Manager")).get_loaded_modules())


def system(port, names):
    """What a profile of the whole system holds; a file of it is written whole or not at all, so all is kept
    until then.
    """
    print(
        "\n".join([str(_running(each, each.get_owned_contexts())) for each in components(start(port), names)])
    )


def _running(each, contexts):
    """What a profile says of one component; the ports are asked first, as asking for the profile may be the
    end of it.
    """
    ports = [
        (
            _kind(found),
            found.name,
            [
                [(one.name, one.value.value()) for one in connector.properties]
                for connector in found.connector_profiles
            ],
        )
        for found in _port_profiles(each)
    ]
    kept = each.get_configuration()
    active, sets = kept.get_active_configuration_set().id, [
        (found.id, [(one.name, one.value.value()) for one in found.configuration_data])
        for found in kept.get_configuration_sets()
    ]
    known = [(each.get_context_handle(context), profile.kind, profile.rate)
             for context, profile in [(context, context.get_profile()) for context in contexts]]
    return (
        _texts(each.get_component_profile()),
        len(each.get_owned_organizations()),
        active,
        sets,
        known,
        ports,
    )


def compared(port, words):
    """What differs from a file, the first of `words`, and what is not Inactive."""
    file, *names = words
    from xml.etree import ElementTree
    rts = "{http://www.openrtp.org/namespaces/rts}"
    wanted = {
        found.get(rts + "instanceName"): found for found in ElementTree.parse(file).iter(rts + "Components")
    }
    for each, name in zip(components(start(port), names), names):
        contexts = each.get_owned_contexts()
        texts, _, active, sets, known, _ = _running(each, contexts)
        told = wanted[texts[0]]
        kept = [(found.get(rts + "id"), [(one.get(rts + "name"), one.get(rts + "data")) for one in found])
                for found in told.iter(rts + "ConfigurationSets")]
        if told.get(rts + "activeConfigurationSet") != active or kept != sets:
            print(name, "differs")
        for context in contexts + each.get_participating_contexts():
            if context.get_component_state(each) != idl.items("RTC.LifeCycleState")[1]:
                print(name, "is not Inactive")


if __name__ == "__main__":
    globals()[sys.argv[1]](sys.argv[2], sys.argv[3:])
    sys.stdout.flush()
    os._exit(0)  # as our commands do: the ORB's end costs 6 ms
