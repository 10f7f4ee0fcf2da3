bash "$COMMON/truncated_zip.sh"
