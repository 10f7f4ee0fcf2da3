"""What `plan` and `map` have in common: they plan fields and load the plans."""

from qgis.core import QgsProcessing, QgsProcessingException

from .base import TramlineAlgorithm
from .layers import given_layer, is_one_field
from .parameters import (
    FIELD,
    GPKG_ENDING,
    ID_FIELD,
    OUTPUT,
    PICTURE,
    PICTURE_ENDINGS,
    add_field,
    add_gates,
    add_id_field,
    add_layer_outputs,
    add_machine,
    add_numbers,
    add_obstacles,
    add_plan_outputs,
    add_run,
    further_options,
    gate_options,
    machine_options,
    number_of,
    obstacle_options,
)
from .results import PLAN_LAYERS, load_file

_LAYERS = (
    ("TRACKS", "Tracks", QgsProcessing.TypeVectorLine),
    ("HEADLAND_PASSES", "Headland passes", QgsProcessing.TypeVectorLine),
    ("ROUTE_LEGS", "Route", QgsProcessing.TypeVectorLine),
    ("SWATHS", "Swaths", QgsProcessing.TypeVectorPolygon),
    ("OVERLAP", "Overlap", QgsProcessing.TypeVectorPolygon),
    ("UNCOVERED", "Uncovered land", QgsProcessing.TypeVectorPolygon),
)
# Sums over the fields planned: the name, the text, and the key of the program's JSON.
_SUMS = (
    ("AREA_M2", "Land, m²", "area_m2"),
    ("TRACK_COUNT", "Pieces of tracks", "tracks"),
    ("TRACK_LENGTH_M", "Length of the tracks, m", "track_length_m"),
    ("TURNS", "Turns", "turns"),
    ("OVERLAP_M2", "Overlap, m²", "overlap_m2"),
    ("UNCOVERED_M2", "Uncovered land, m²", "uncovered_m2"),
)
_WHOLE_SUMS = (("HOURS", "Hours of the whole route", "hours"), ("EUROS", "Cost of the whole route, €", "euros"))


class Planning(TramlineAlgorithm):
    def declare(self):
        add_field(self)
        add_machine(self)
        self.declare_choices()
        add_obstacles(self)
        add_id_field(self)
        add_gates(self)
        add_run(self)
        add_plan_outputs(self)
        add_layer_outputs(self, _LAYERS)
        add_numbers(self, [("FIELDS", "Fields planned"), ("REFUSED", "Fields refused")])
        add_numbers(self, [(name, text) for name, text, _ in _SUMS + _WHOLE_SUMS])

    def declare_choices(self):
        raise NotImplementedError

    def chosen_options(self, parameters, context, feedback):
        raise NotImplementedError

    def work(self, parameters, context, feedback):
        source = self.parameterAsSource(parameters, FIELD, context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, FIELD))
        machine = machine_options(self, parameters, context)
        named = self.parameterAsString(parameters, ID_FIELD, context)
        field = given_layer(self, parameters, FIELD, context, feedback, named)
        output = self.output_file(parameters, OUTPUT, context, GPKG_ENDING)
        several = not is_one_field(source)
        options = {
            "layer": field.layer, "crs": field.crs, "all": several, "one-file": several,
            **machine,
            **obstacle_options(self, parameters, context, feedback),
            **gate_options(self, parameters, context, source.sourceCrs()),
            **self.chosen_options(parameters, context, feedback),
            "seconds": number_of(self, parameters, "SECONDS", context),
            "output": output,
            "picture": self.output_file(parameters, PICTURE, context, PICTURE_ENDINGS),
        }
        done = self.run_program(
            feedback, [field.file], options, further_options(self, parameters, context), max(1, source.featureCount())
        )
        return self.results(done, output, options["picture"], context)

    def results(self, done, output, picture, context):
        plans = [one for one in done.results if "area_m2" in one]
        names = plans[0].get("field_id") or "field" if len(plans) == 1 else f"{len(plans)} fields"
        layers = load_file(output, PLAN_LAYERS, context, f"{self.title.split(' (')[0]}: {names}")
        out = {OUTPUT: output, "FIELDS": len(plans), "REFUSED": sum("error" in one for one in done.results)}
        if picture:
            out[PICTURE] = picture
        out.update({name: layers[name.lower()] for name, _, _ in _LAYERS if name.lower() in layers})
        out.update({name: sum(plan[key] for plan in plans) for name, _, key in _SUMS})
        whole = [plan["whole_cost"] for plan in plans if plan.get("whole_cost")]
        if whole:
            out.update({name: sum(one[key] for one in whole) for name, _, key in _WHOLE_SUMS})
        return out
