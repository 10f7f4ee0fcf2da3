"""Parameters that several algorithms have, and what the program is told of them."""

from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingOutputNumber,
    QgsProcessingOutputVectorLayer,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
    QgsProcessingParameterString,
)

from .layers import given_layer

FIELD, ID_FIELD, OUTPUT, PICTURE = "FIELD", "ID_FIELD", "OUTPUT", "PICTURE"
OPERATIONS = ("general", "seeding", "spraying", "spreading", "tillage", "mowing", "harvest", "robot weeding", "drone")
GPKG_FILTER, PICTURE_FILTER = "GeoPackage (*.gpkg)", "Pictures (*.png *.svg *.pdf)"
GPKG_ENDING, PICTURE_ENDINGS = ".gpkg", (".png", ".svg", ".pdf")


def advanced(parameter):
    parameter.setFlags(parameter.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
    return parameter


def number(name, text, least=0.0, default=None):
    """A length or another amount that may be left out."""
    return QgsProcessingParameterNumber(
        name, text, QgsProcessingParameterNumber.Double, default, True, least, 1e6
    )


def add_field(algorithm, text="Fields", optional=False):
    algorithm.addParameter(
        QgsProcessingParameterFeatureSource(FIELD, text, [QgsProcessing.TypeVectorPolygon], None, optional)
    )


def add_id_field(algorithm):
    algorithm.addParameter(
        advanced(QgsProcessingParameterField(
            ID_FIELD, "Attribute that names the fields (otherwise: id)", None, FIELD, optional=True
        ))
    )


def add_machine(algorithm):
    algorithm.addParameter(number("WIDTH", "Working width, m", 0.01))
    algorithm.addParameter(number("RADIUS", "Least turning radius, m"))
    algorithm.addParameter(
        QgsProcessingParameterFile("MACHINE", "Machine file, in place of width and radius", extension="toml", optional=True)
    )


def machine_options(algorithm, parameters, context):
    """Throws QgsProcessingException where there is no machine at all."""
    machine = algorithm.parameterAsFile(parameters, "MACHINE", context)
    width = number_of(algorithm, parameters, "WIDTH", context)
    if width is None and not machine:
        raise QgsProcessingException("Give a working width, or a machine file that has one.")
    return {"width": width, "radius": number_of(algorithm, parameters, "RADIUS", context), "machine": machine}


def number_of(algorithm, parameters, name, context):
    """None where the parameter is left out."""
    return None if parameters.get(name) is None else algorithm.parameterAsDouble(parameters, name, context)


def add_operation(algorithm):
    """Without a default: a machine file may say what the machine does."""
    algorithm.addParameter(
        QgsProcessingParameterEnum("OPERATION", "What the machine does", list(OPERATIONS), False, None, True, True)
    )


def chosen(algorithm, parameters, name, context):
    """The word of an enumeration of static words."""
    return None if parameters.get(name) is None else algorithm.parameterAsEnumString(parameters, name, context)


def add_obstacles(algorithm):
    algorithm.addParameter(
        QgsProcessingParameterFeatureSource(
            "OBSTACLES", "Obstacles, besides the holes of the fields", [QgsProcessing.TypeVectorAnyGeometry], None, True
        )
    )
    algorithm.addParameter(
        advanced(QgsProcessingParameterFeatureSource(
            "PASSABLE", "Strips that may be crossed with the work interrupted", [QgsProcessing.TypeVectorPolygon], None, True
        ))
    )


def obstacle_options(algorithm, parameters, context, feedback):
    """The program reads all layers of these files."""
    out = {}
    for name in ("OBSTACLES", "PASSABLE"):
        given = given_layer(algorithm, parameters, name, context, feedback, only_layer=True)
        out[name.lower()] = given.file if given else None
    return out


def add_gates(algorithm):
    for name, text in (("START", "Gate where the route starts"), ("END", "Gate where the route ends")):
        algorithm.addParameter(advanced(QgsProcessingParameterPoint(name, text, None, True)))


def gate_options(algorithm, parameters, context, crs):
    out = {}
    for name in ("START", "END"):
        if parameters.get(name):
            at = algorithm.parameterAsPoint(parameters, name, context, crs)
            out[name.lower()] = f"{at.x()!r},{at.y()!r}"
    return out


def add_run(algorithm, seconds=True):
    """The time limit, and all other options of the command as they are typed."""
    if seconds:
        algorithm.addParameter(advanced(number("SECONDS", "End each search after so many seconds", 0.001)))
    algorithm.addParameter(
        advanced(QgsProcessingParameterString(
            "OPTIONS", f"Further options, as after 'tramline {algorithm.command}'", None, False, True
        ))
    )


def further_options(algorithm, parameters, context):
    return algorithm.parameterAsString(parameters, "OPTIONS", context)


def add_plan_outputs(algorithm, optional=False):
    algorithm.addParameter(QgsProcessingParameterFileDestination(OUTPUT, "Plan", GPKG_FILTER, None, optional, not optional))
    add_picture(algorithm)


def add_picture(algorithm):
    algorithm.addParameter(QgsProcessingParameterFileDestination(PICTURE, "Picture", PICTURE_FILTER, None, True, False))


def add_layer_outputs(algorithm, names):
    for name, text, kind in names:
        algorithm.addOutput(QgsProcessingOutputVectorLayer(name, text, kind))


def add_numbers(algorithm, names):
    for name, text in names:
        algorithm.addOutput(QgsProcessingOutputNumber(name, text))


def add_flag(algorithm, name, text, default=False):
    algorithm.addParameter(QgsProcessingParameterBoolean(name, text, default, True))
