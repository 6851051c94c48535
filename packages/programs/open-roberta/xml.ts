/** Characters that XML cannot hold, not even written as numbers. */
const suspicious = /[\p{Cc}\p{Cs}\uFFFE\uFFFF]/gu
const possible = /[\t\n\r\u007F-\u009F]/
const whole = (text: string) =>
  text.replace(suspicious, (character) => (possible.test(character) ? character : '\uFFFD'))

const inText: { readonly [character: string]: string } = {
  ...{ '&': '&amp;', '<': '&lt;', '>': '&gt;', '\r': '&#13;' },
}
const inAttribute: { readonly [character: string]: string } = {
  ...inText,
  ...{ '"': '&quot;', '\n': '&#10;', '\t': '&#9;' },
}

/** Does it hold only what XML can hold? */
export const isWhole = (text: string): boolean => whole(text) === text

export const textOf = (text: string): string =>
  whole(text).replace(/[&<>\r]/g, (character) => inText[character]!)

const attribute = (text: string): string =>
  whole(text).replace(/[&<>\r"\n\t]/g, (character) => inAttribute[character]!)

/** One element; `inside` is XML already. */
export function element(name: string, attributes: { readonly [name: string]: string }, inside = ''): string {
  const written = Object.entries(attributes).map(([key, value]) => ` ${key}="${attribute(value)}"`)
  return `<${name}${written.join('')}>${inside}</${name}>`
}
