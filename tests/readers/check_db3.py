#!/usr/bin/python3
"""Prints how many messages Python's sqlite3 finds in a .db3 bag; fails when the database is not
sound or the count is not the second argument."""

import sqlite3
import sys

database = sqlite3.connect(sys.argv[1])
integrity = database.execute("PRAGMA integrity_check").fetchone()[0]
messages = database.execute(
    "SELECT count(*) FROM messages JOIN topics ON topics.id = topic_id").fetchone()[0]
print(f"{messages} messages, integrity: {integrity}")
sys.exit(0 if integrity == "ok" and messages == int(sys.argv[2]) else 1)
