# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the client believe that Pygments is not installed: with it and Python 3.13, ParaView 5.13
crashes when it shows a script."""
raise ImportError("hidden from the client")
