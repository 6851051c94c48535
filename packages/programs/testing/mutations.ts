import { readFileSync, readdirSync } from 'node:fs'
import { draw, stream, type StreamState } from '@botgarten/numbers'
import { check, ProjectError, type Program } from '../index.ts'
import { readOpenRoberta, writeOpenRoberta } from '../open-roberta/index.ts'
import { robotIn } from '../open-roberta/brick.ts'

const folder = new URL('open-roberta/programs/', import.meta.url)

/** The given programs, by name. */
export const givenFiles = (): { readonly [file: string]: string } =>
  Object.fromEntries(
    readdirSync(folder).map((file) => [file, readFileSync(new URL(file, folder), 'utf8')] as const),
  )

type Chance = StreamState
const upTo = (chance: Chance, most: number) => Math.floor(draw(chance) * (most + 1))
const pick = <Thing>(chance: Chance, things: readonly Thing[]): Thing =>
  things[upTo(chance, things.length - 1)]!

function range(chance: Chance, text: string): readonly [number, number] {
  const length = Math.min(text.length, upTo(chance, pick(chance, [1, 10, 100, 3000])))
  const from = upTo(chance, text.length - length)
  return [from, from + length]
}

/** Whole elements from `<block` or another tag on, up to some end tag of that name. */
function elementIn(chance: Chance, text: string): readonly [number, number] {
  const name = pick(chance, ['block', 'value', 'statement', 'field', 'mutation', 'instance', 'repetitions'])
  const begins = [...text.matchAll(new RegExp(`<${name}[ >]`, 'g'))].map(({ index }) => index)
  if (begins.length === 0) return range(chance, text)
  const from = pick(chance, begins)
  const end = text.indexOf(`</${name}>`, from)
  return [from, end < 0 ? text.length : end + name.length + 3]
}

const hostile = [
  '&', '<', '>', '"', "'", '\0', '\uFFFF', '\uD800', '&#0;', '&#x110000;', '&#xD800;', '&amp', '&lol;', ']]>', '<![CDATA[',
  '<!--', '--', '<?php ?>', '<!DOCTYPE a [<!ENTITY b "c">]>', '<!ENTITY x SYSTEM "file:///etc/passwd">', '</block>', '<block>',
  '<next>', '<x:y>', ' xmlns:x="urn:x"', ' xmlns="urn:y"', ' __proto__="1"', '<field name="__proto__">1</field>',
  '<value name="constructor"/>', ' x="NaN"', ' x="1e999"', ' robottype="mbot"', 'ev3', ' type=""', ' id=""', ' disabled="maybe"',
  '\u202E', '🤖', '<shadow type="a" id="b"/>', '<data>{"a":', '<comment/>', '<repetitions/>', ' items="1e9"', ' elseif="-1"', ' wait="99999999"',
] // prettier-ignore

const bomb = (depth: number) =>
  `<!DOCTYPE e [<!ENTITY l0 "ha">${Array.from({ length: depth }, (_, k) => `<!ENTITY l${k + 1} "${`&l${k};`.repeat(10)}">`).join('')}]>`

type Change = (chance: Chance, text: string, other: string) => string
const between = (text: string, [from, to]: readonly [number, number], put: string) =>
  text.slice(0, from) + put + text.slice(to)

/** What happens to a file, by name. */
const changes: { readonly [name: string]: Change } = {
  cut: (chance, text) => between(text, range(chance, text), ''),
  'cut off': (chance, text) => text.slice(0, upTo(chance, text.length)),
  'cut an element': (chance, text) => between(text, elementIn(chance, text), ''),
  double(chance, text) {
    const [from, to] = range(chance, text)
    return between(text, [from, to], text.slice(from, to).repeat(2))
  },
  'double an element'(chance, text) {
    const [from, to] = elementIn(chance, text)
    return between(text, [from, to], text.slice(from, to).repeat(pick(chance, [2, 2, 3, 200])))
  },
  swap(chance, text) {
    const [a, b] = [range(chance, text), range(chance, text)].sort(([x], [y]) => x - y) as [
      [number, number],
      [number, number],
    ]
    if (a[1] > b[0]) return text
    return (
      text.slice(0, a[0]) + text.slice(...b) + text.slice(a[1], b[0]) + text.slice(...a) + text.slice(b[1])
    )
  },
  'swap elements'(chance, text) {
    const part = elementIn(chance, text)
    const place = elementIn(chance, text)
    return between(text, place, text.slice(...part))
  },
  'from another file': (chance, text, other) =>
    between(text, elementIn(chance, text), other.slice(...elementIn(chance, other))),
  hostile: (chance, text) => between(text, range(chance, text), pick(chance, hostile)),
  'hostile twice'(chance, text) {
    const once = between(
      text,
      [upTo(chance, text.length), 0].fill(upTo(chance, text.length)) as [number, number],
      pick(chance, hostile),
    )
    const at = upTo(chance, once.length)
    return between(once, [at, at], pick(chance, hostile))
  },
  'an attribute': (chance, text) =>
    text.replaceAll(pick(chance, ['type="', 'id="', 'name="', 'x="', 'items="']), (found) =>
      draw(chance) < 0.9
        ? found
        : `${found}${pick(chance, ['', '&lt;', '-1', '1e309', '__proto__', 'x'.repeat(300)])}`,
    ),
  entities: (chance, text) => bomb(upTo(chance, 12)) + text.replace('</field>', '&l9;</field>'),
  deep(chance, text) {
    const count = pick(chance, [3, 60, 500, 20_000])
    const open = '<block type="robControls_loopForever" id="d"><statement name="DO">'.repeat(count)
    const at = text.indexOf('</instance>')
    const close = draw(chance) < 0.5 ? '</statement></block>'.repeat(count) : ''
    return between(text, [at, at], open + close)
  },
  'deep values'(chance, text) {
    const count = pick(chance, [3, 60, 140, 500])
    const at = text.indexOf('</instance>')
    const open = '<block type="math_arithmetic" id="v"><field name="OP">ADD</field><value name="A">'.repeat(
      count,
    )
    return between(
      text,
      [at, at],
      `<block type="robActions_display_text" id="t"><value name="OUT">${open}<block type="math_number" id="n"/>${'</value></block>'.repeat(count)}</value></block>`,
    )
  },
  large(chance, text) {
    const [from, to] = elementIn(chance, text)
    const size = pick(chance, [100_000, 1_000_000, 6_000_000])
    return between(text, [from, to], text.slice(from, to).repeat(Math.ceil(size / Math.max(1, to - from))))
  },
  'a long text': (chance, text) =>
    text.replace(
      '<field name="',
      `<field name="A">${'x'.repeat(pick(chance, [19_000, 21_000, 300_000]))}</field><field name="`,
    ),
}

/** One of many mutated copies; the same number gives the same one. */
export function mutated(
  files: { readonly [file: string]: string },
  number: number,
): { readonly what: string; readonly text: string } {
  const chance = stream(number, 'mutations')
  const names = Object.keys(files)
  const [file, other] = [pick(chance, names), pick(chance, names)]
  const times = pick(chance, [1, 1, 1, 2, 3])
  let text = files[file]!
  const done: string[] = []
  for (let k = 0; k < times; k++) {
    const name = pick(chance, Object.keys(changes))
    done.push(name)
    text = changes[name]!(chance, text, files[other]!)
  }
  return { what: `${number}: ${file}, ${done.join(', ')}`, text }
}

/** Branches are put into their order when they are written. */
const sorted = (program: Program): string =>
  JSON.stringify(program, (_, value: unknown) =>
    typeof value === 'object' && value !== null && !Array.isArray(value)
      ? Object.fromEntries(Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1)))
      : value,
  )

/**
 * What becomes of a file: the program, or why it was refused. An opened one can be written, read again the same, and looked
 * through for what a child should fix. @throws whatever else happens: a crash
 */
export function opened(text: string): Program | ProjectError {
  let program: Program
  try {
    program = readOpenRoberta(text)
  } catch (error) {
    if (error instanceof ProjectError) return error
    throw error
  }
  const again = readOpenRoberta(writeOpenRoberta(program))
  if (sorted(again) !== sorted(program)) throw new Error('Read again it is another program.')
  check(program, robotIn(program.config))
  return program
}
