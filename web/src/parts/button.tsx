import type { ComponentChildren, JSX } from 'preact';

interface Props extends Omit<JSX.ButtonHTMLAttributes<HTMLButtonElement>, 'type' | 'class'> {
  kind?: 'main' | 'plain' | 'quiet' | 'danger';
  children: ComponentChildren;
}
export const Button = ({ kind = 'plain', children, ...rest }: Props) => (
  <button type="button" class={`button ${kind}`} {...rest}>
    {children}
  </button>
);
