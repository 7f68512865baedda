"""Components of a profile that live though no name leads to them: their name server was started again, empty.

They are asked at the addresses that the file has: those of the components, which rtcryo saves, object
references of data ports, which RTSystemEditor saves with connections, managers by address, and the usual port
of managers on the hosts after which naming contexts are named.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import listed, warn
from rtshell_lite.net import loop
from rtshell_lite.path import MANAGER_PORT
from rtshell_lite.robot import manager
from rtshell_lite.system import capture, relocate
from rtshell_lite.text import counted

# Properties with a reference, and which of the ends has it
SIDES = {"dataport.corba_cdr.outport_ior": 0, "dataport.corba_cdr.inport_ior": -1}
MOST = 100  # addresses that are asked


async def find_living(profile, missing):
    """{path as text: where it answers, in words} of those `missing` Components of a profile that live, and
    {path: (why, its port)} of those that may.
    """
    living, doubts = await _at_references(profile, missing)
    still_missing = [component for component in missing if capture.shown_path(component) not in living]
    living.update(await _at_managers(still_missing))
    return living, doubts


def findings(profile, missing, addresses):
    """A Finding on each name server without any of its Components in the file, of which some live: those at
    the paths that `addresses` has.
    """
    for server, components in sorted(_by_server(profile.components).items()):
        living = [path for path in map(capture.shown_path, components) if path in addresses]
        if living and all(component in missing for component in components):
            verb = "lives" if len(living) == 1 else "live"
            message = (
                f"has none of its {counted(len(components), 'component')} in the file, though "
                f"{listed(living)} {verb}: perhaps it was started again, and they were not, or it is another "
                "name server"
            )
            yield warn("name server", server, message, remedies.words("bind again"))


def _by_server(components):
    servers = {}
    for component in components:
        try:
            where = capture.path_of(component)
        except errors.BadPath:
            continue
        servers.setdefault(str(where._replace(names=())), []).append(component)
    return servers


async def _at_references(profile, missing):
    """What `find_living` returns, by their references, and those to data ports."""
    locate = capture.locator(profile)
    refs = {}
    doubts = {}
    for component, ref in zip(missing, await loop.each(missing, capture.living_reference)):
        where = capture.shown_path(component)
        if isinstance(ref, errors.Error):
            why = await capture.doubt(component, relocate.path_in(component.path_uri), ref)
            if why:
                doubts[where] = why, orb.endpoint(capture.saved_reference(component))[1]
        elif ref is not None:
            refs[where] = ref, "it answers"
    for connector in profile.connectors:
        for item in connector.properties:
            end = SIDES.get(item.name)
            component = locate(connector.ends[end]) if end is not None and connector.ends else None
            if component not in missing:
                continue
            try:
                ref = orb.from_text(connector.name, item.value or "")
            except errors.Unreachable:
                continue
            refs.setdefault(capture.shown_path(component), (ref, "its port answers"))
    asked = list(refs.items())[:MOST]
    answers = await session.each(
        [ref for _, (ref, _) in asked], lambda ref: orb.is_alive("", ref), orb.at_object
    )
    living = {
        path: f"{words} at {orb.at_address(ref)}"
        for (path, (ref, words)), answer in zip(asked, answers)
        if answer is True
    }
    return living, doubts


async def _at_managers(missing):
    """{path: where it answers, in words}, by the managers that list a component of this name."""
    paths = {}  # paths by the address of a manager and the name of an instance
    for component in missing:
        for word in _managers(component):
            paths.setdefault(word, {})[component.instance_name] = capture.shown_path(component)
    words = sorted(paths)[:MOST]
    answers = await session.each(words, _listed_by, lambda word: (word, word))
    living = {}
    for word, answer in zip(words, answers):
        if isinstance(answer, errors.Error):
            continue
        listed = {name for name, _ in answer}
        for name in listed & set(paths[word]):
            living[paths[word][name]] = f"the manager {word} has it"
    return living


async def _listed_by(word):
    return await manager.components(await manager.find(word))


def _managers(component):
    """Addresses at which the manager of a Component may be."""
    own = component.property(capture.MANAGER) or ""
    if own.startswith("corbaloc:"):
        yield own
    try:
        where = capture.path_of(component)
    except errors.BadPath:
        return
    for name in where.names:
        if name.kind == "host_cxt" and name.id:
            yield "corbaloc::%s:%d/manager" % (name.id, MANAGER_PORT)
