const drawn = 'http://www.w3.org/2000/svg'

export function make<Name extends keyof SVGElementTagNameMap>(
  name: Name,
  attributes: { readonly [name: string]: string | number } = {},
): SVGElementTagNameMap[Name] {
  const element = document.createElementNS(drawn, name)
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value))
  return element
}

/** What is so already is not touched: it would be painted anew. */
export function set(element: Element | null, name: string, value: string): void {
  if (element?.getAttribute(name) !== value) element?.setAttribute(name, value)
}
