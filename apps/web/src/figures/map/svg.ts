const drawn = 'http://www.w3.org/2000/svg'

export function make<Name extends keyof SVGElementTagNameMap>(
  name: Name,
  attributes: { readonly [name: string]: string | number } = {},
): SVGElementTagNameMap[Name] {
  const element = document.createElementNS(drawn, name)
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value))
  return element
}

/** Two dots in the corners: a layer whose size changed would have every layer of the page arranged again. */
export const corners = ({ width, height }: { readonly width: number; readonly height: number }) =>
  ({ d: `M0 0h1M${width - 1} ${height}h1`, stroke: '#000', 'stroke-opacity': 0.01 }) as const

/** What is so already is not touched: it would be painted again. */
export function set(element: Element | null, name: string, value: string): void {
  if (element?.getAttribute(name) !== value) element?.setAttribute(name, value)
}
