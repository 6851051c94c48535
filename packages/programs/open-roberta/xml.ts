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

/** The entries of a record by the names that XML can hold; of two that become the same the first. */
export function entriesByName<Value>(record: {
  readonly [name: string]: Value
}): readonly (readonly [name: string, value: Value])[] {
  const seen = new Set<string>()
  return Object.entries(record).filter(([name]) => !seen.has(whole(name)) && seen.add(whole(name)))
}

/** Does it hold only what XML can hold? */
export const isWhole = (text: string): boolean => whole(text) === text

export const textOf = (text: string): string =>
  whole(text).replace(/[&<>\r]/g, (character) => inText[character]!)

const attribute = (text: string): string =>
  whole(text).replace(/[&<>\r"\n\t]/g, (character) => inAttribute[character]!)

export const namespace = 'http://de.fhg.iais.roberta.blockly'

const starts = String.raw`A-Za-z_\u00C0-\u00D6\u00D8-\u00F6\u00F8-\u02FF\u0370-\u037D\u037F-\u1FFF\u200C-\u200D\u2070-\u218F\u2C00-\u2FEF\u3001-\uD7FF\uF900-\uFDCF\uFDF0-\uFFFD`
const plainName = new RegExp(String.raw`^[${starts}][${starts}\d.\-\u00B7\u203F-\u2040]*$`)

/** Can an element have this attribute, in a document that has one namespace? */
export function isAttribute(name: string, value: string): boolean {
  if (name === 'xmlns') return ['', namespace].includes(value)
  const [prefix, local, ...more] = name.split(':') as [string, ...string[]]
  if (local === undefined) return plainName.test(name)
  if (more.length > 0 || !plainName.test(local)) return false
  return prefix === 'xml' || (prefix === 'xmlns' && value !== '' && !['xml', 'xmlns'].includes(local))
}

/** One element; `inside` is XML already. A project may hold attributes that XML cannot have: they are left out. */
export function element(name: string, attributes: { readonly [name: string]: string }, inside = ''): string {
  const written = Object.entries(attributes)
    .filter(([key, value]) => isAttribute(key, value))
    .map(([key, value]) => ` ${key}="${attribute(value)}"`)
  return `<${name}${written.join('')}>${inside}</${name}>`
}
