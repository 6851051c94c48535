import type { Template } from '../types.ts'
import { functions } from './expression-functions.ts'
import { robotFunctions, type RobotArgument } from './expression-robot.ts'
import { ExpressionError, tokensOf, type Token } from './expression-tokens.ts'

/** Brackets in brackets, at most 60. Each is two steps down, and so is the whole. */
const deepest = 2 * 60 + 2

const constants: { readonly [name: string]: string } = {
  pi: 'PI',
  e: 'E',
  phi: 'GOLDEN_RATIO',
  sqrt2: 'SQRT2',
  sqrt_1_2: 'SQRT1_2',
  inf: 'INFINITY',
}

const colours: { readonly [name: string]: string } = {
  '#black': '#000000',
  '#blue': '#0057A6',
  '#green': '#00642E',
  '#yellow': '#F7D117',
  '#red': '#B30006',
  '#white': '#FFFFFF',
  '#brown': '#532115',
  '#gray': '#585858',
}

const binary =
  (type: string, OP: string) =>
  (A: Template, B: Template): Template => ({ type, fields: { OP }, values: { A, B } })

type Level = ReadonlyMap<string, (a: Template, b: Template) => Template>

/** From what binds least to what binds most. */
const levels: readonly Level[] = [
  new Map([['||', binary('logic_operation', 'OR')]]),
  new Map([['&&', binary('logic_operation', 'AND')]]),
  new Map([
    ['==', binary('logic_compare', 'EQ')],
    ['!=', binary('logic_compare', 'NEQ')],
    ['<', binary('logic_compare', 'LT')],
    ['<=', binary('logic_compare', 'LTE')],
    ['>', binary('logic_compare', 'GT')],
    ['>=', binary('logic_compare', 'GTE')],
  ]),
  new Map([
    ['+', binary('math_arithmetic', 'ADD')],
    ['-', binary('math_arithmetic', 'MINUS')],
  ]),
  new Map([
    ['*', binary('math_arithmetic', 'MULTIPLY')],
    ['/', binary('math_arithmetic', 'DIVIDE')],
  ]),
  new Map([
    [
      '%',
      (DIVIDEND: Template, DIVISOR: Template) => ({ type: 'math_modulo', values: { DIVIDEND, DIVISOR } }),
    ],
  ]),
]

/** Reads an expression as the blocks that mean the same. Recursive descent, one function a rule. @throws {ExpressionError} */
export function expressionIn(text: string): Template {
  const reader = new Reader(tokensOf(text))
  const template = reader.expression()
  reader.expect('')
  return template
}

class Reader {
  readonly #tokens: readonly Token[]
  #at = 0
  #depth = 0

  constructor(tokens: readonly Token[]) {
    this.#tokens = tokens
  }

  get #token(): Token {
    return this.#tokens[this.#at] ?? { kind: 'end', text: '', at: 0 }
  }

  #next(): Token {
    const token = this.#token
    this.#at++
    return token
  }

  #fail(): never {
    throw new ExpressionError(this.#token.at)
  }

  #take(sign: string): boolean {
    const taken = this.#token.text === sign && this.#token.kind !== 'text'
    if (taken) this.#at++
    return taken
  }

  expect(sign: string): void {
    if (sign === '' ? this.#token.kind !== 'end' : !this.#take(sign)) this.#fail()
  }

  expression(): Template {
    if (++this.#depth > deepest) this.#fail()
    const condition = this.#level(0)
    const template = this.#take('?') ? this.#choice(condition) : condition
    this.#depth--
    return template
  }

  #choice(IF: Template): Template {
    const THEN = this.expression()
    this.expect(':')
    return { type: 'logic_ternary', values: { IF, THEN, ELSE: this.expression() } }
  }

  #level(depth: number): Template {
    const level = levels[depth]
    if (!level) return this.#signed()
    let left = this.#level(depth + 1)
    for (let make = level.get(this.#token.text); make && this.#token.kind === 'sign';) {
      this.#at++
      left = make(left, this.#level(depth + 1))
      make = level.get(this.#token.text)
    }
    return left
  }

  #signed(): Template {
    if (++this.#depth > deepest) this.#fail()
    const template = this.#signedInside()
    this.#depth--
    return template
  }

  #signedInside(): Template {
    if (this.#take('!')) return { type: 'logic_negate', values: { BOOL: this.#signed() } }
    if (this.#take('+')) return this.#signed()
    if (this.#take('-'))
      return { type: 'math_single', fields: { OP: 'NEG' }, values: { NUM: this.#signed() } }
    const base = this.#atom()
    return this.#take('^') ? binary('math_arithmetic', 'POWER')(base, this.#signed()) : base
  }

  #atom(): Template {
    if (this.#take('(')) return this.#inBrackets()
    if (this.#take('[')) return functions.get('createListWith')!.make(this.#list(']'))
    const token = this.#token
    switch (token.kind) {
      case 'number':
        this.#at++
        return { type: 'math_number', fields: { NUM: String(Number(token.text)) } }
      case 'text':
        this.#at++
        return { type: 'text', fields: { TEXT: token.text.slice(1, -1) } }
      case 'colour':
        return this.#colour()
      case 'name':
        return this.#named()
      case 'sign':
      case 'end':
        return this.#fail()
    }
  }

  #inBrackets(): Template {
    const template = this.expression()
    this.expect(')')
    return template
  }

  /** What stands between commas, up to `close`. */
  #list(close: string): Template[] {
    if (this.#take(close)) return []
    const list = [this.expression()]
    while (this.#take(',')) list.push(this.expression())
    this.expect(close)
    return list
  }

  #colour(): Template {
    const { text } = this.#token
    const value = text.startsWith('#rgb') ? `#${text.slice(5, 11).toUpperCase()}` : colours[text]
    if (value === undefined) this.#fail()
    this.#at++
    return { type: 'robColour_picker', fields: { COLOUR: value } }
  }

  #named(): Template {
    const token = this.#next()
    const name = token.text
    if (name === 'ev3' && this.#take('.')) return this.#robot()
    if (this.#token.text === '(') return this.#call(token)
    if (name === 'true' || name === 'false')
      return { type: 'logic_boolean', fields: { BOOL: name.toUpperCase() } }
    if (name === 'null') return { type: 'logic_null' }
    if (Object.hasOwn(constants, name))
      return { type: 'math_constant', fields: { CONSTANT: constants[name] ?? '' } }
    return { type: 'variables_get', fields: { VAR: name } }
  }

  #call({ text: name, at }: Token): Template {
    this.expect('(')
    const args = this.#list(')')
    const known = functions.get(name)
    if (!known) return this.#callOfProgram(name, args)
    if (known.takes !== null && known.takes !== args.length) throw new ExpressionError(at)
    return known.make(args)
  }

  /** A function that the program makes. */
  #callOfProgram(name: string, args: readonly Template[]): Template {
    return {
      type: 'robProcedures_callreturn',
      mutation: { attrs: { name }, args: args.map((_, k) => ({ name: String(k), type: '' })) },
      values: Object.fromEntries(args.map((arg, k) => [`ARG${k}`, arg])),
    }
  }

  #robot(): Template {
    const { at } = this.#token
    let path = this.#next().text
    while (this.#take('.')) path += `.${this.#next().text}`
    this.expect('(')
    const template = robotFunctions.get(path)?.(this.#robotArguments())
    if (!template) throw new ExpressionError(at)
    return template
  }

  #robotArguments(): RobotArgument[] {
    const args: RobotArgument[] = []
    while (!this.#take(')')) {
      if (args.length > 0) this.expect(',')
      args.push(this.#robotArgument())
    }
    return args
  }

  /** A lone word may be a port's or a variable's name: both are kept. */
  #robotArgument(): RobotArgument {
    const { text, kind } = this.#token
    const value = this.expression()
    return kind === 'name' || kind === 'number' ? { word: text, value } : { value }
  }
}
