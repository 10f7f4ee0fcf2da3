"""tramline check: does a plan hold?"""

import html

from qgis.core import (
    QgsProcessingOutputBoolean,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterString,
)

from .base import TramlineAlgorithm
from .layers import given_layer
from .parameters import FIELD, add_field, add_numbers, add_obstacles, add_run, further_options, obstacle_options


class Check(TramlineAlgorithm):
    command = "check"
    title = "Check plans"
    help_text = (
        "Verifies plans by a method that knows nothing of the planner: areas, turns and stops are computed again from the tracks alone, every "
        "track and turn is driven again. With the layer that the plan was made from, field and obstacles are compared as well.\n\n"
        "The report lists what does not hold, with its place."
    )

    def declare(self):
        self.addParameter(QgsProcessingParameterFile("PLAN", "Plan", extension="gpkg"))
        add_field(self, "Fields that the plan was made from", optional=True)
        add_obstacles(self)
        self.addParameter(QgsProcessingParameterString("ID", "Only the plan of this field", None, False, True))
        add_run(self, seconds=False)
        self.addParameter(QgsProcessingParameterFileDestination("REPORT", "Report", "HTML (*.html)", None, True))
        self.addOutput(QgsProcessingOutputBoolean("HOLDS", "All plans hold"))
        add_numbers(self, [("PLANS", "Plans"), ("VIOLATIONS", "Violations")])

    def work(self, parameters, context, feedback):
        plan = self.parameterAsFile(parameters, "PLAN", context)
        field = given_layer(self, parameters, FIELD, context, feedback)
        report = self.output_file(parameters, "REPORT", context, ".html")
        options = {
            "field": field.file if field else None,
            "crs": field.crs if field else None,
            **obstacle_options(self, parameters, context, feedback),
            "id": self.parameterAsString(parameters, "ID", context),
        }
        # 1: a plan does not hold.
        done = self.run_program(feedback, [plan], options, further_options(self, parameters, context), fine=(0, 1))
        violations = [(one["field_id"], violation) for one in done.results for violation in one["violations"]]
        for name, violation in violations:
            feedback.reportError(f"{name}: {violation['rule']}: {violation['what']}")
        if not violations:
            feedback.pushInfo("All plans hold." if len(done.results) > 1 else "The plan holds.")
        if report:
            with open(report, "w", encoding="utf-8") as out:
                out.write(_page(plan, done.results))
        out = {"HOLDS": all(one["ok"] for one in done.results), "PLANS": len(done.results), "VIOLATIONS": len(violations)}
        if report:
            out["REPORT"] = report
        return out


def _page(plan, results):
    text = [f"<html><head><meta charset='utf-8'><title>{html.escape(plan)}</title></head><body><h1>{html.escape(plan)}</h1>"]
    for one in results:
        text.append(f"<h2>{html.escape(one['field_id'])}: {'holds' if one['ok'] else 'does not hold'}</h2>")
        for title, key in (("Violations", "violations"), ("Findings", "findings")):
            if one[key]:
                text.append(f"<h3>{title}</h3><ul>{''.join(_item(each) for each in one[key])}</ul>")
        text.append(_figures(one))
        if one["not_verified"]:
            text.append(f"<p>Not verified: {html.escape(', '.join(one['not_verified']))}</p>")
    return "\n".join([*text, "</body></html>\n"])


def _item(violation):
    at = "" if violation["x_m"] is None else f" (x {violation['x_m']:.3f} m, y {violation['y_m']:.3f} m)"
    return f"<li>{html.escape(violation['rule'])}: {html.escape(violation['what'])}{at}</li>"


def _figures(one):
    found = one["recomputed"] or {}
    rows = "".join(
        f"<tr><td>{html.escape(key)}</td><td>{stored}</td><td>{found.get(key, '')}</td></tr>" for key, stored in one["stored"].items()
    )
    return f"<table><tr><th></th><th>stored</th><th>recomputed</th></tr>{rows}</table>"
