import sax from 'sax'
import { numbersIn } from './path.ts'
import { compose, identity, matrixOf, type Matrix } from './transform.ts'
import type { MapProblem } from './types.ts'

/** An element of a drawing. */
export interface Element {
  readonly name: string
  readonly attributes: { readonly [name: string]: string }
  /** How many elements it stands in. */
  readonly depth: number
  /** From the coordinates inside it to those of the map, whose corner is at 0, 0. */
  readonly matrix: Matrix
  /** A transform of it, or of what it stands in, that cannot be read. */
  readonly unreadTransform: string | null
}

const MOST_ELEMENTS = 5_000
/** Of one element. */
const MOST_ATTRIBUTES = 200
const DEEPEST = 100

export const SVG = 'http://www.w3.org/2000/svg'
/** What drawing programs note for themselves; it draws nothing. */
const notes = new Set([
  'http://www.inkscape.org/namespaces/inkscape',
  'http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd',
  'http://www.w3.org/1999/02/22-rdf-syntax-ns#',
  'http://creativecommons.org/ns#',
  'http://purl.org/dc/elements/1.1/',
])

/** Drawing elements that a map may hold; none of them runs or reaches outside. */
export const harmless = new Set([
  'svg',
  'g',
  'path',
  'circle',
  'ellipse',
  'rect',
  'text',
  'tspan',
  'line',
  'polyline',
  'polygon',
  'title',
  'desc',
  'metadata',
  'defs',
  'linearGradient',
  'radialGradient',
  'stop',
  'pattern',
  'clipPath',
  'image',
])
const reachesOut = /url\((?!\s*["']?#)|javascript:|data:/i
/** A style that could hide an address (an escape, a comment) or load one. */
const unclearStyle = /[\\@]|\/\*|expression|binding/i

/** A picture that stands in the file itself. A drawing in a drawing is none: it could hold anything again. */
export const isPicture = (address: string) =>
  /^data:image\/(?:png|jpe?g|gif|webp);base64,[a-z0-9+/=\s]*$/i.test(address)

export type Elements =
  { readonly elements: readonly Element[]; readonly unsafe: string | null } | { readonly problem: MapProblem }

/** No entities but those of XML itself, of which the types of the parser do not know. */
const options: sax.SAXOptions & { readonly strictEntities: true } = { strictEntities: true }

/** Ends the reading of a document: at its first error, and where it is too much. */
class Broken extends Error {
  readonly problem: MapProblem

  constructor(kind: MapProblem['kind'], facts: MapProblem['facts']) {
    super(kind)
    this.problem = { kind, facts }
  }
}

/** An open element: what it says of namespaces, and itself where it is part of the drawing. */
interface Open {
  readonly namespaces: ReadonlyMap<string, string>
  readonly drawn: Element | null
}

/** All elements of a document in order; `unsafe` names the first that is more than a drawing. */
export function elementsOf(text: string): Elements {
  const parser = sax.parser(true, options)
  const elements: Element[] = []
  const open: Open[] = []
  let count = 0
  let attributeCount = 0
  let unsafe: string | null = null
  const most = (kind: MapProblem['kind'], count: number, most: number) => {
    if (count > most) throw new Broken(kind, { most })
  }
  parser.onerror = () => {
    throw new Broken('notXml', { line: parser.line + 1 })
  }
  parser.ondoctype = () => (unsafe ??= '!DOCTYPE')
  parser.onattribute = () => most('tooManyAttributes', ++attributeCount, MOST_ATTRIBUTES)
  parser.onclosetag = () => open.pop()
  parser.onopentag = ({ name, attributes: read }) => {
    const attributes = read as Element['attributes']
    attributeCount = 0
    most('tooManyElements', ++count, MOST_ELEMENTS)
    most('tooDeep', open.length + 1, DEEPEST)
    const namespaces = namespacesIn(attributes)
    const [prefix, local] = name.includes(':') ? (name.split(':') as [string, string]) : ['', name]
    const uri = [...open, { namespaces }]
      .findLast((one) => one.namespaces.has(prefix))
      ?.namespaces.get(prefix)
    const isDrawn = uri === SVG || (uri === undefined && prefix === '')
    if (!notes.has(uri ?? '') && !(isDrawn && harmless.has(local))) unsafe ??= name
    unsafe ??= Object.keys(attributes).find((one) => isUnsafe(one, attributes[one]!)) ?? null
    const outside = open.findLast(({ drawn }) => drawn)?.drawn
    const drawn = isDrawn ? elementIn(outside, local, attributes, open.length) : null
    if (drawn) elements.push(drawn)
    open.push({ namespaces, drawn })
  }
  try {
    parser.write(text).close()
  } catch (error) {
    if (error instanceof Broken) return { problem: error.problem }
    return { problem: { kind: 'notXml', facts: { line: parser.line + 1 } } }
  }
  return { elements, unsafe }
}

/** By prefix; the one without a prefix is ''. */
export const namespacesIn = (attributes: Element['attributes']): Open['namespaces'] =>
  new Map(
    Object.entries(attributes).flatMap(([name, value]) => {
      const found = /^xmlns(?::(.*))?$/.exec(name)
      return found ? [[found[1] ?? '', value] as const] : []
    }),
  )

export function isUnsafe(name: string, value: string): boolean {
  if (/href$/i.test(name)) return !value.startsWith('#') && !isPicture(value)
  if (/^(?:.*:)?on|^filter$/i.test(name) || reachesOut.test(value)) return true
  return /^style$/i.test(name) && unclearStyle.test(value)
}

function elementIn(
  outside: Element | null | undefined,
  name: string,
  attributes: Element['attributes'],
  depth: number,
): Element {
  const around = outside ?? { matrix: cornerOf(attributes), unreadTransform: null }
  const text = outside && name === 'svg' ? 'svg' : (attributes['transform'] ?? '')
  const own = matrixOf(text)
  const matrix = compose(around.matrix, own ?? identity)
  return { name, attributes, depth, matrix, unreadTransform: around.unreadTransform ?? (own ? null : text) }
}

/** The view box begins at 0, 0 of the map. */
function cornerOf(attributes: Element['attributes']): Matrix {
  const [x = 0, y = 0] = numbersIn(attributes['viewBox'] ?? '') ?? []
  return [1, 0, 0, 1, -x, -y]
}
