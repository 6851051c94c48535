import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { addBlocks, definitions, type BlockType, type Template } from '../index.ts'
import { expert } from '../packs/expert/index.ts'
import { functions } from './expression-functions.ts'
import { ExpressionError } from './expression-tokens.ts'
import { expressionIn } from './expressions.ts'

addBlocks(expert)

/** The tree as a Lisp would write it: nothing is left to binding. */
function lisp({ type, fields = {}, values = {}, mutation }: Template): string {
  const name = mutation?.attrs?.['name'] ?? type.replace(/^\w+?_/, '')
  const words = [name, ...Object.values(fields), ...Object.values(values).map(lisp)]
  return type === 'math_number' ? fields['NUM']! : `(${words.join(' ')})`
}
const read = (text: string) => lisp(expressionIn(text))

function whereItFails(text: string): number | null {
  try {
    expressionIn(text)
    return null
  } catch (error) {
    if (error instanceof ExpressionError) return error.at
    throw error
  }
}

describe('rule 32: binding', () => {
  it.each([
    ['1 + 2 * 3', '(arithmetic ADD 1 (arithmetic MULTIPLY 2 3))'],
    ['(1 + 2) * 3', '(arithmetic MULTIPLY (arithmetic ADD 1 2) 3)'],
    ['1 - 2 - 3', '(arithmetic MINUS (arithmetic MINUS 1 2) 3)'],
    ['8 / 4 / 2', '(arithmetic DIVIDE (arithmetic DIVIDE 8 4) 2)'],
    ['2 * 7 % 4', '(arithmetic MULTIPLY 2 (modulo 7 4))'],
    ['2 ^ 3 ^ 2', '(arithmetic POWER 2 (arithmetic POWER 3 2))'],
    ['-2 ^ 2', '(single NEG (arithmetic POWER 2 2))'],
    ['2 ^ -1', '(arithmetic POWER 2 (single NEG 1))'],
    [
      '1 + 2 > 2 && 3 < 4 || a == b',
      '(operation OR (operation AND (compare GT (arithmetic ADD 1 2) 2) (compare LT 3 4)) (compare EQ (get a) (get b)))',
    ],
    ['!a && b', '(operation AND (negate (get a)) (get b))'],
    ['a ? 1 : b ? 2 : 3', '(ternary (get a) 1 (ternary (get b) 2 3))'],
    ['a != b ? 1 : 2', '(ternary (compare NEQ (get a) (get b)) 1 2)'],
  ])('%s is %s', (text, tree) => {
    expect(read(text)).toBe(tree)
  })
})

describe('what stands in an expression', () => {
  it.each([
    ['.5', '0.5'],
    ['3.', '3'],
    ['007', '7'],
    ['pi', '(constant PI)'],
    ['inf', '(constant INFINITY)'],
    ['größe_2', '(get größe_2)'],
    ['"a + b"', '(text a + b)'],
    ['""', '(text )'],
    ['#red', '(picker #B30006)'],
    ['#rgb(a0b0c0)', '(picker #A0B0C0)'],
    ['true', '(boolean TRUE)'],
    ['null', '(null)'],
    ['[]', '(create_with)'],
    ['[1, 2]', '(create_with 1 2)'],
    ['sqrt(9)', '(single ROOT 9)'],
    ['constrain(x, 0, 9)', '(constrain (get x) 0 9)'],
    ['getFromEnd([1], 0)', '(getIndex GET FROM_END (create_with 1) 0)'],
    ['createTextWith("a", 1)', '(join (text a) 1)'],
    ['castStringToNumber("7")', '(cast_string_toNumber (text 7))'],
    ['castToChar(65)', '(cast_toChar 65)'],
    ['ev3.connectToRobot("Bo 2")', '(startConnection (text Bo 2))'],
    ['mine(1, 2)', '(mine 1 2)'],
    ['  1\n+\t2 ', '(arithmetic ADD 1 2)'],
  ])('%s is %s', (text, tree) => {
    expect(read(text)).toBe(tree)
  })

  it('is every function of Open Roberta’s grammar, with as many values as it takes', () => {
    for (const [name, { takes }] of functions) {
      const args = (count: number) => Array.from({ length: count }, () => '1').join(', ')
      const wanted = takes ?? 3
      const { type, values = {} } = expressionIn(`${name}(${args(wanted)})`)
      const { inputs, items } = definitions[type as BlockType].look
      const places = [...inputs.map((input) => input.name), ...(items ? ['ADD0', 'ADD1', 'ADD2'] : [])]
      expect(places, name).toEqual(expect.arrayContaining(Object.keys(values)))
      expect(Object.keys(values), name).toHaveLength(wanted)
      if (takes !== null) expect(whereItFails(`1 + ${name}(${args(takes + 1)})`), name).toBe(4)
    }
  })
})

describe('what cannot be read is named by its place', () => {
  it.each([
    ['', 0],
    ['1 +', 3],
    ['1 2', 2],
    ['(1', 2],
    ['1)', 1],
    ['a ? 1', 5],
    ['sqrt(1', 6],
    ['#nocolour', 0],
    ['"open', 0],
    ['1 & 2', 2],
    ['= 1', 0],
    ['ev3.noSuchThing()', 4],
    [`${'('.repeat(61)}1${')'.repeat(61)}`, 61],
  ])('%s: at %i', (text, place) => {
    expect(whereItFails(text)).toBe(place)
  })

  it('sixty brackets are read', () => {
    expect(whereItFails(`${'('.repeat(60)}1${')'.repeat(60)}`)).toBeNull()
  })

  it('any text is read, or named by a place in it', () => {
    const signs = fc.constantFrom(...'+-*/%^!<>=?:(),.[]"#&| 1a', 'sqrt', 'pi', 'ev3')
    fc.assert(
      fc.property(fc.array(signs, { maxLength: 30 }), (pieces) => {
        const text = pieces.join('')
        const place = whereItFails(text)
        if (place === null) return
        expect(place).toBeGreaterThanOrEqual(0)
        expect(place).toBeLessThanOrEqual(text.length)
      }),
      { numRuns: 2000, seed: 32 },
    )
  })
})

// ---- printed trees are read as the same trees

const signs = { ADD: '+', MINUS: '-', MULTIPLY: '*', DIVIDE: '/', POWER: '^' } as const
/** How tight a sign binds. */
const binding = { ADD: 1, MINUS: 1, MULTIPLY: 2, DIVIDE: 2, POWER: 4 } as const

/** With no bracket that binding makes needless. */
function printed({ type, fields = {}, values = {} }: Template, around = 0, isRight = false): string {
  if (type === 'math_number') return fields['NUM']!
  const op = fields['OP'] as keyof typeof signs
  const own = binding[op]
  const right = op === 'POWER'
  const [a, b] = [printed(values['A']!, own, right), printed(values['B']!, own, !right)]
  const text = `${a} ${signs[op]} ${b}`
  return around > own || (around === own && isRight) ? `(${text})` : text
}

const { tree } = fc.letrec<{ tree: Template; sum: Template }>((tie) => ({
  tree: fc.oneof(
    { maxDepth: 5, withCrossShrink: true },
    fc.nat(99).map((x): Template => ({ type: 'math_number', fields: { NUM: String(x) } })),
    tie('sum'),
  ),
  sum: fc
    .tuple(fc.constantFrom('ADD', 'MINUS', 'MULTIPLY', 'DIVIDE', 'POWER'), tie('tree'), tie('tree'))
    .map(([OP, A, B]): Template => ({ type: 'math_arithmetic', fields: { OP }, values: { A, B } })),
}))

it('a tree that is printed with as few brackets as may be is read as the same tree', () => {
  fc.assert(
    fc.property(tree, (one) => {
      expect(expressionIn(printed(one))).toEqual(one)
    }),
    { numRuns: 1000, seed: 32 },
  )
})
