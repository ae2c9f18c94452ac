# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the document objects look and what a double click on them does."""
