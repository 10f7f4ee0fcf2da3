cat >machine.toml <<'TOML'
width_m = = 6
TOML
