"""The program tramline as this plugin calls it. Nothing in here needs QGIS."""
