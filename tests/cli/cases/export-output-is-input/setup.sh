bash "$COMMON/riverside_plan.sh" 12
mv plan.gpkg plan.zip
