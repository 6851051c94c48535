import sax from 'sax'

/** An element of a drawing that matters to a map. */
export interface Element {
  readonly name: string
  readonly attributes: { readonly [name: string]: string }
}

/** Drawing elements that a map may hold; none of them runs or reaches outside. */
const harmless = new Set([
  'svg',
  'g',
  'path',
  'circle',
  'ellipse',
  'rect',
  'text',
  'line',
  'polyline',
  'polygon',
  'title',
  'desc',
])
const reachesOut = /url\(|javascript:|data:/i
const runs = /^on|href$|^style$|^filter$/i

export type Elements =
  { readonly elements: readonly Element[]; readonly unsafe: string | null } | { readonly line: number }

/** No entities but those of XML itself, of which the types of the parser do not know. */
const options: sax.SAXOptions & { readonly strictEntities: true } = { strictEntities: true }

/** All elements of a document in order; `unsafe` names the first that is more than a drawing. A line where it is no XML. */
export function elementsOf(text: string): Elements {
  const parser = sax.parser(true, options)
  const elements: Element[] = []
  let line: number | null = null
  let unsafe: string | null = null
  parser.onerror = () => (line ??= parser.line + 1)
  parser.ondoctype = () => (unsafe ??= '!DOCTYPE')
  parser.onopentag = ({ name, attributes }) => {
    const own = attributes as Element['attributes']
    elements.push({ name, attributes: own })
    if (!harmless.has(name)) unsafe ??= name
    for (const [attribute, value] of Object.entries(own))
      if (runs.test(attribute) || reachesOut.test(value)) unsafe ??= attribute
  }
  try {
    parser.write(text).close()
  } catch {
    line ??= parser.line + 1
  }
  return line === null ? { elements, unsafe } : { line }
}
