cat >machine.toml <<'TOML'
wdith_m = 6
turning_radius_m = 6
TOML
