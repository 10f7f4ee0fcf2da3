"""The tables and figures of the three papers, repeated: `make papers`, or PYTHONPATH=tools python3 -m papers.

One module for each paper, `lookalikes` and `routes` for the fields and drives they need, `program` to run tramline,
`tables` for CSV and Markdown.
"""
