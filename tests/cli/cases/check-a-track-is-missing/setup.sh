bash "$COMMON/riverside_plan.sh" 6
ogrinfo -q plan.gpkg -sql "DELETE FROM tracks WHERE fid = (SELECT MIN(fid) FROM tracks)" >/dev/null
