"""tramline map: headlands and tracks along a line or an edge."""

from qgis.core import (
    QgsProcessing,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterString,
)

from .layers import given_layer
from .parameters import advanced
from .planning import Planning

_DIRECTIONS = (("the cheapest straight ones", "never"), ("curved where that costs less", "auto"), ("curved along edges", "always"))
_END_RULES = ("cheapest", "cover", "inside", "centre")


class Map(Planning):
    command = "map"
    title = "Map fields along a line"
    help_text = (
        "Maps fields with headland passes and tracks parallel to a line: an AB line, a drawn curve, or an edge of the field. Without a "
        "line the direction that costs least is found.\n\n"
        "The result is a plan without a route; its layers are loaded in the colours of tramline's pictures."
    )

    def declare_choices(self):
        self.addParameter(
            QgsProcessingParameterFeatureSource("GUIDE", "Line to follow", [QgsProcessing.TypeVectorLine], None, True)
        )
        self.addParameter(
            QgsProcessingParameterEnum("DIRECTION", "Tracks, where there is no line", [text for text, _ in _DIRECTIONS], False, 0)
        )
        self.addParameter(QgsProcessingParameterString("HEADLANDS", "Headland passes: a number, or auto", "0", False, True))
        self.addParameter(
            advanced(QgsProcessingParameterEnum("END_RULE", "Where swaths end", list(_END_RULES), False, _END_RULES[0], False, True))
        )
        self.addParameter(advanced(QgsProcessingParameterBoolean("ROUTE", "Plan the route as well", False, True)))

    def chosen_options(self, parameters, context, feedback):
        guide = given_layer(self, parameters, "GUIDE", context, feedback, only_layer=True)
        along = _DIRECTIONS[self.parameterAsEnum(parameters, "DIRECTION", context)][1]
        return {
            "guide": guide.file if guide else None,
            "curved": None if guide else along,
            "headlands": self.parameterAsString(parameters, "HEADLANDS", context),
            "end-rule": self.parameterAsEnumString(parameters, "END_RULE", context),
            "route": "whole" if self.parameterAsBoolean(parameters, "ROUTE", context) else None,
        }
