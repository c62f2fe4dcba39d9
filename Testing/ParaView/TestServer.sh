#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
# Runs TestServer.py beside a pvserver, which ends when its only client leaves.
# usage: TestServer.sh <pvserver> <pvpython> <log file>
set -e
port=$("$2" -c "
import socket
with socket.socket() as probe:
    probe.bind(('', 0))
    print(probe.getsockname()[1])
" | tail -n 1)
"$1" --server-port="$port" >"$3" 2>&1 &
server=$!
trap 'kill $server 2>/dev/null || true' EXIT
until grep -q "Accepting connection" "$3"; do
  kill -0 $server
  sleep 0.1
done
"$2" "$(dirname "$0")/TestServer.py" "$port"
wait $server
! grep "ERR|" "$3"
