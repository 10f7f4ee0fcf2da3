"""tramline plan: every pass over a field."""

from qgis.core import QgsProcessingParameterBoolean, QgsProcessingParameterEnum, QgsProcessingParameterString

from .parameters import add_operation, advanced, chosen
from .planning import Planning

# What is minimised: the text, and the options.
_AIMS = (
    ("the cost of the whole route: hours, fuel, land worked twice and missed", {}),
    ("tracks alone, by the prices below", {}),
    ("tracks alone, least overlap before all else", {"minimise": "overlap"}),
    ("tracks alone, least uncovered land before all else", {"minimise": "uncovered"}),
    ("tracks alone, fewest turns before all else", {"minimise": "turns"}),
)
_BY_PRICES = 1


class Plan(Planning):
    command = "plan"
    title = "Plan fields"
    help_text = (
        "Plans every pass of a machine over each field: headlands as its turns need them, tracks, detours round obstacles, turns and "
        "the way between, and takes the plan that costs least. Or plans tracks alone, without headlands and route.\n\n"
        "Holes of the fields are obstacles. Land is measured in a plane centred on the field, whatever the CRS of the layer. All "
        "fields go into one GeoPackage, whose layers are loaded in the colours of tramline's pictures. Fields that cannot be planned "
        "are listed with the reason in the log.\n\n"
        "All other options of the program can be typed under 'Further options', such as --clearance 0.5."
    )

    def declare_choices(self):
        add_operation(self)
        self.addParameter(QgsProcessingParameterEnum("AIM", "What is minimised", [text for text, _ in _AIMS], False, 0))
        self.addParameter(
            advanced(QgsProcessingParameterString(
                "PRICES", "Prices of overlap (€/m²), uncovered land (€/m²), a turn, a stop, a further subfield (€)",
                "0.02,0.10,1,5,5", False, True,
            ))
        )
        self.addParameter(
            advanced(QgsProcessingParameterString("HEADLANDS", "Headland passes: a number, or auto", None, False, True))
        )
        self.addParameter(advanced(QgsProcessingParameterBoolean("REVERSE", "The machine may reverse when it turns", False, True)))

    def chosen_options(self, parameters, context, feedback):
        aim = self.parameterAsEnum(parameters, "AIM", context)
        return {
            "operation": chosen(self, parameters, "OPERATION", context),
            **_AIMS[aim][1],
            "prices": self.parameterAsString(parameters, "PRICES", context) if aim == _BY_PRICES else None,
            "headlands": self.parameterAsString(parameters, "HEADLANDS", context),
            "reverse": self.parameterAsBoolean(parameters, "REVERSE", context),
        }
