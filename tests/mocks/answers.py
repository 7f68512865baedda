"""Short ways to read what mocks answer."""
import worlds


def names(profile):
    return [item.name for item in profile.properties]


def value(items, name):
    return next(item.value.value() for item in items if item.name == name)


def raised(function, *arguments):
    """The name of the exception that a call raises, or None."""
    try:
        function(*arguments)
    except (worlds.CORBA.UserException, worlds.CORBA.SystemException) as e:
        return e._NP_RepositoryId.split("/")[-1].split(":")[0]
    return None


def outcome(function, *arguments):
    """The name of what a call raises or, of its results, returns first."""
    results = []
    failure = raised(lambda: results.append(function(*arguments)))
    return failure or str(results[0][0] if isinstance(results[0], tuple) else results[0])
