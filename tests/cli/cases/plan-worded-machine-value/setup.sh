cat >machine.toml <<'TOML'
width_m = "six"
turning_radius_m = 6
TOML
