"""Files of results as layers of the project, in the colours of the program's pictures."""

import os
import sqlite3
from contextlib import closing

from qgis.core import QgsProcessingContext, QgsProcessingLayerPostProcessorInterface, QgsVectorLayer

# From the top of the map to its ground. Layers without features are left out.
PLAN_LAYERS = (
    "encounters", "route_legs", "turns", "headland_passes", "tracks", "given_up", "uncovered", "headland_unworked", "overlap",
    "obstacles", "headland", "swaths", "subfields", "worked", "field",
)
COVERAGE_LAYERS = ("gaps", "track", "missed", "not_recorded", "repeated", "covered", "field")
# Shown only when the user ticks them: they say again, in more detail, what others say.
_HIDDEN = {"swaths", "encounters", "multiplicity"}


class _Styled(QgsProcessingLayerPostProcessorInterface):
    """Gives a layer the style in its file and its place in a group."""

    alive = []  # QGIS keeps no reference

    def __init__(self, group, layers):
        super().__init__()
        self._group, self._layers = group, list(layers)
        # Those of former runs have done their work long ago.
        self.alive[:] = [*self.alive[-200:], self]

    def postProcessLayer(self, layer, context, feedback):
        if isinstance(layer, QgsVectorLayer):
            layer.loadDefaultStyle()
            layer.triggerRepaint()
        project = context.project()
        node = project.layerTreeRoot().findLayer(layer.id()) if project is not None else None
        if node is not None:
            self._move(project.layerTreeRoot(), node, layer)

    def _move(self, root, node, layer):
        group = root.findGroup(self._group) or root.insertGroup(0, self._group)
        name = _layer_name(layer.source())
        rank = self._rank(name)
        above = [child for child in group.findLayers() if self._rank(_layer_name(child.layer().source())) < rank]
        moved = node.clone()
        moved.setItemVisibilityChecked(name not in _HIDDEN)
        moved.setExpanded(False)
        group.insertChildNode(len(above), moved)
        node.parent().removeChildNode(node)

    def _rank(self, name):
        return self._layers.index(name) if name in self._layers else len(self._layers)


def _layer_name(source):
    return source.rsplit("|layername=", 1)[-1].split("|")[0]


def filled_layers(file, wanted):
    """Those of the layers of a GeoPackage that have features."""
    with closing(sqlite3.connect(f"file:{file}?mode=ro", uri=True)) as database:
        tables = {name for (name,) in database.execute("SELECT table_name FROM gpkg_contents")}
        return [
            name for name in wanted
            if name in tables and database.execute(f'SELECT 1 FROM "{name}" LIMIT 1').fetchone() is not None
        ]


def load_file(file, wanted, context, group):
    """Has the layers of a GeoPackage loaded when the algorithm ends. Gives what each is called by other algorithms."""
    out = {}
    if context.project() is None or not os.path.exists(file):
        return {name: f"{file}|layername={name}" for name in filled_layers(file, wanted)} if os.path.exists(file) else {}
    for name in filled_layers(file, wanted):
        uri = out[name] = f"{file}|layername={name}"
        _load(uri, name, wanted, context, group)
    return out


def load_table(file, title, context, group):
    """Has a CSV loaded when the algorithm ends."""
    if context.project() is not None and os.path.exists(file):
        _load(file, title, (), context, group)


def _load(uri, title, order, context, group):
    details = QgsProcessingContext.LayerDetails(title, context.project(), title)
    details.setPostProcessor(_Styled(group, order))
    if hasattr(details, "groupName"):  # QGIS 3.32
        details.groupName = group
    if hasattr(details, "layerSortKey") and title in order:
        details.layerSortKey = len(order) - list(order).index(title)
    context.addLayerToLoadOnCompletion(uri, details)
