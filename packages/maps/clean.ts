import sax from 'sax'
import { isPicture, isUnsafe, namespacesIn, SVG, harmless } from './elements.ts'
import { numbersIn } from './path.ts'
import { sizeOf } from './read-number.ts'
import type { MapProblem } from './types.ts'

/** A drawing of another program, taken apart: what a map is read from, and what lies under it. */
export interface CleanedDrawing {
  /** Stations, roads, and the shapes around them, as an SVG without looks. */
  readonly plan: string
  /** All the rest that is drawn, as an SVG that runs nothing and reaches nothing outside; null: nothing is left. */
  readonly picture: string | null
  /** What was taken out, by its name, each once. */
  readonly removed: readonly string[]
}

/** Characters of a file, its pictures among them. */
const MOST_CHARACTERS = 2_000_000
const MOST_ELEMENTS = 5_000
const MOST_ATTRIBUTES = 200
const DEEPEST = 100
/** Names for addresses that Illustrator writes into the head of its files. */
const MOST_ENTITIES = { count: 50, letters: 200, uses: 2_000 }

/** What is drawn by more than one shape, and looks that may be shared. Only a picture has them. */
const pictorial = new Set([...harmless, 'use', 'symbol', 'mask', 'marker', 'style', 'switch', 'a'])
/** Their content is drawn without them. */
const wrappers = new Set(['switch', 'a'])
/** Of these a map is read. */
const planned = new Set([...['svg', 'g', 'path', 'circle', 'ellipse', 'rect', 'line', 'polyline']])
const shapes = /^(?:path|circle|ellipse|rect|line|polyline|polygon|text|image|use)$/
const geometry = /^(?:id|d|transform|cx|cy|r|rx|ry|x|y|x1|y1|x2|y2|width|height|points|viewBox|data-[a-z-]+)$/

interface Node {
  readonly name: string
  readonly attributes: { readonly [name: string]: string }
  readonly inside: (Node | string)[]
}

/** Ends the reading of a file. */
class Refused extends Error {
  readonly problem: MapProblem

  constructor(kind: MapProblem['kind'], facts: MapProblem['facts']) {
    super(kind)
    this.problem = { kind, facts }
  }
}

/**
 * Reads a drawing of any program by a list of what may stay (elements of SVG that draw, pictures inside the file, links
 * within it); all else is taken out and named. A name like `node_x2D_0`, as Illustrator writes `node-0`, is read as meant.
 */
export function cleanDrawing(text: string): CleanedDrawing | { readonly problem: MapProblem } {
  if (text.length > MOST_CHARACTERS)
    return { problem: { kind: 'tooLarge', facts: { most: MOST_CHARACTERS } } }
  const removed = new Set<string>()
  try {
    const root = treeOf(text, removed)
    if (root?.name !== 'svg') return { problem: { kind: 'noDrawing', facts: {} } }
    const rest = withoutRings(sized(pictureOf(root, removed)!))
    const picture = draws(rest) ? written(rest) : null
    return { plan: written(planOf(root)), picture, removed: [...removed] }
  } catch (error) {
    if (error instanceof Refused) return { problem: error.problem }
    throw error
  }
}

/** The elements of SVG in a file; those of others are left out with all that is in them. */
function treeOf(text: string, removed: Set<string>): Node | null {
  const parser = sax.parser(true, { strictEntities: true } as sax.SAXOptions)
  const root: Node = { name: '', attributes: {}, inside: [] }
  const open = [{ node: root as Node | null, namespaces: new Map<string, string>() }]
  let [count, attributeCount] = [0, 0]
  const most = (kind: MapProblem['kind'], count: number, most: number) => {
    if (count > most) throw new Refused(kind, { most })
  }
  const broken = () => new Refused('notXml', { line: parser.line + 1 })
  parser.onerror = () => {
    throw broken()
  }
  parser.ondoctype = (type) => Object.assign(parser.ENTITIES, entitiesIn(type, text))
  parser.onattribute = () => most('tooManyAttributes', ++attributeCount, MOST_ATTRIBUTES)
  parser.onclosetag = () => open.pop()
  parser.ontext = parser.oncdata = (text) => open.at(-1)!.node?.inside.push(text)
  parser.onopentag = ({ name, attributes: read }) => {
    const attributes = read as Node['attributes']
    attributeCount = 0
    most('tooManyElements', ++count, MOST_ELEMENTS)
    most('tooDeep', open.length, DEEPEST)
    const around = open.at(-1)!
    const own = namespacesIn(attributes)
    const namespaces = own.size > 0 ? new Map([...around.namespaces, ...own]) : around.namespaces
    const [prefix, local] = name.includes(':') ? (name.split(':') as [string, string]) : ['', name]
    const uri = namespaces.get(prefix)
    const isDrawn = uri === SVG || (uri === undefined && prefix === '')
    const stays = around.node !== null && isDrawn && pictorial.has(local)
    if (around.node !== null && isDrawn && !stays && !isQuiet(local, attributes)) removed.add(name)
    const node = stays ? { name: local, attributes: cleaned(local, attributes, removed), inside: [] } : null
    if (node) around.node!.inside.push(node)
    open.push({ node, namespaces })
  }
  try {
    parser.write(text).close()
  } catch (error) {
    throw error instanceof Refused ? error : broken()
  }
  return root.inside.find((one) => typeof one !== 'string') ?? null
}

/** Fonts and shadows are left out without a word, and what a program notes for itself. */
const isQuiet = (element: string, attributes: Node['attributes']) =>
  /^(?:font|glyph|missing-glyph|hkern|filter|fe[A-Z]|metadata)/.test(element) ||
  attributes['requiredExtensions'] !== undefined

/** `<!ENTITY name "address">` of the head, where they are few, short and hold no other. */
function entitiesIn(type: string, text: string): { readonly [name: string]: string } {
  const found = [...type.matchAll(/<!ENTITY\s+([\w.-]+)\s+"([^"&<%]*)"\s*>/g)]
  const uses = text.match(/&[a-z]\w*;/gi)?.length ?? 0
  if (found.length > MOST_ENTITIES.count || uses > MOST_ENTITIES.uses) return {}
  return Object.fromEntries(
    found.flatMap(([, name, value]) => (value!.length <= MOST_ENTITIES.letters ? [[name!, value!]] : [])),
  )
}

function cleaned(element: string, attributes: Node['attributes'], removed: Set<string>): Node['attributes'] {
  const kept = Object.entries(attributes).flatMap(([name, value]) => {
    if (/^xmlns(?::|$)/.test(name)) return []
    if (name.includes(':') && name !== 'xlink:href') return isUnsafe(name, value) ? report(name, removed) : []
    if (name === 'filter') return []
    const isHref = /href$/i.test(name)
    if (isUnsafe(name, value) || (isHref && element === 'a')) return report(name, removed)
    if (isHref && isPicture(value) && element !== 'image') return report(name, removed)
    return [[name === 'xlink:href' ? 'href' : name, name === 'id' ? meant(value) : value] as const]
  })
  return Object.fromEntries(kept)
}

function report(name: string, removed: Set<string>): [] {
  removed.add(name)
  return []
}

/** Illustrator writes letters that it takes for odd as `_xHH_`. */
const meant = (id: string) =>
  id.replace(/_x([0-9A-F]{2})_/g, (_, code: string) => String.fromCharCode(Number.parseInt(code, 16)))

const isOfMap = ({ attributes: { id = '' } }: Node) => /^node-\d+$|^path-\d+-\d+$/.test(id)

function planOf({ name, attributes, inside }: Node): Node {
  const kept = Object.entries(attributes).filter(([name, value]) => geometry.test(name) && says(name, value))
  const parts = inside.flatMap((one): Node[] => {
    if (typeof one === 'string') return []
    if (wrappers.has(one.name)) return [planOf({ ...one, name: 'g' })]
    return planned.has(one.name) ? [planOf(one)] : []
  })
  return { name, attributes: Object.fromEntries(kept), inside: parts }
}

/** Ids of shapes that are neither stations nor roads may stand there twice. */
const says = (name: string, value: string) => name !== 'id' || /^(?:node|path)[-_ ]/i.test(value)

/** Without stations and roads, and with styles that only say looks. */
function pictureOf(node: Node, removed: Set<string>): Node | null {
  if (isOfMap(node)) return null
  if (node.name === 'style') return styleOf(node, removed)
  const { name, attributes } = node
  const inside = node.inside.flatMap((one): (Node | string)[] | Node =>
    typeof one === 'string' ? (isWritten(name) ? [one] : []) : (pictureOf(one, removed) ?? []),
  )
  return { name: wrappers.has(name) ? 'g' : name, attributes, inside }
}

const isWritten = (element: string) => /^(?:text|tspan|title|desc)$/.test(element)

/** Fonts of the file and rules that load anything are left out; what remains are colours and widths. */
function styleOf({ attributes, inside }: Node, removed: Set<string>): Node | null {
  const rules = inside.filter((one) => typeof one === 'string').join('')
  const plain = rules.replace(/\/\*[^]*?\*\//g, '').replace(/@font-face\s*\{[^}]*\}/gi, '')
  if (!/[\\@<]|expression|binding|javascript:|data:|url\((?!\s*["']?#)/i.test(plain))
    return { name: 'style', attributes, inside: [plain] }
  removed.add('style')
  return null
}

/** A copy of what holds copies again could grow without end: such copies are left out. */
function withoutRings(root: Node): Node {
  const holders = new Set<string>()
  const look = (node: Node): boolean => {
    const holds =
      node.inside.map((one) => typeof one !== 'string' && look(one)).some(Boolean) || node.name === 'use'
    if (holds && node.attributes['id']) holders.add(`#${node.attributes['id']}`)
    return holds
  }
  look(root)
  const prune = (node: Node): Node => ({
    ...node,
    inside: node.inside.flatMap((one): (Node | string)[] =>
      typeof one === 'string'
        ? [one]
        : one.name === 'use' && holders.has(one.attributes['href'] ?? '')
          ? []
          : [prune(one)],
    ),
  })
  return prune(root)
}

/** A root that is as large as its view box: so the map is read from it, and so it shall be drawn. */
function sized(root: Node): Node {
  const { width, height } = sizeOf(root)
  const [x = 0, y = 0] = numbersIn(root.attributes['viewBox'] ?? '') ?? []
  const size = { width: String(width), height: String(height), viewBox: `${x} ${y} ${width} ${height}` }
  const { x: _x, y: _y, ...attributes } = root.attributes
  return { ...root, attributes: { ...attributes, ...(width > 0 && height > 0 && size) } }
}

/** Is anything seen of it? What is only defined is not. */
const draws = ({ name, inside }: Node): boolean =>
  shapes.test(name) ||
  (!/^(?:defs|clipPath|mask|symbol|marker|pattern)$/.test(name) &&
    inside.some((one) => typeof one !== 'string' && draws(one)))

const escapes: { readonly [sign: string]: string } = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' }
const escaped = (text: string) => text.replace(/[&<>"]/g, (sign) => escapes[sign]!)

function written({ name, attributes, inside }: Node, isRoot = true): string {
  const said = Object.entries(attributes).map(([key, value]) => ` ${key}="${escaped(value)}"`)
  const head = isRoot ? ` xmlns="${SVG}"` : ''
  const content = inside.map((one) => (typeof one === 'string' ? escaped(one) : written(one, false)))
  return `<${name}${head}${said.join('')}>${content.join('')}</${name}>`
}
