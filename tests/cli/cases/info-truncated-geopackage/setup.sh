bash "$COMMON/truncated_geopackage.sh"
