"""tramline in the Processing toolbox of QGIS. The work is done by the program tramline, which this plugin calls."""


def classFactory(iface):
    from .plugin import Plugin

    return Plugin(iface)
