import type { ComponentChildren } from 'preact';

export const Expander = ({ title, open = false, children }: { title: ComponentChildren; open?: boolean; children: ComponentChildren }) => (
  <details class="more" open={open}>
    <summary>{title}</summary>
    <div class="inside">{children}</div>
  </details>
);
