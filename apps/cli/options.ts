import { parseArgs, type ParseArgsConfig } from 'node:util'
import { CallError } from './errors.ts'
import { languages, message, type Language } from './words.ts'

export type Options = NonNullable<ParseArgsConfig['options']>

/** What every call takes; it is heard before its command begins. */
export const everywhere = { lang: { type: 'string' }, help: { type: 'boolean' } } as const

/** Reads options; what is unknown or has no value is the call's fault. */
export function options<const Known extends Options>(args: string[], known: Known) {
  try {
    return parseArgs({ args, options: known, allowPositionals: true })
  } catch (error) {
    throw wrongOption(error as NodeJS.ErrnoException)
  }
}

function wrongOption({ code, message }: NodeJS.ErrnoException): CallError {
  const option = /'(--?[^' ]+)/.exec(message)?.[1]
  if (option === undefined) return new CallError('call.unclear', { message })
  if (code === 'ERR_PARSE_ARGS_UNKNOWN_OPTION') return new CallError('call.unknownOption', { option })
  const takesNone = message.includes('does not take')
  return new CallError(takesNone ? 'call.noValue' : 'call.needsValue', { option })
}

/** Ends a call that names something where nothing is to be named. */
export function refuseMore([word]: readonly string[]): void {
  if (word !== undefined) throw new CallError('call.tooMany', { word })
}

/** A number of the call within its range. */
export function numberIn(
  name: string,
  text: string | undefined,
  preset: number,
  least: number,
  most: number,
): number {
  if (text === undefined) return preset
  const number = Number(text)
  if (text.trim() === '' || !(number >= least && number <= most))
    throw new CallError('call.number', { name, least, most, text })
  return number
}

export function wholeNumberIn(
  name: string,
  text: string | undefined,
  preset: number,
  least: number,
  most: number,
): number {
  const number = numberIn(name, text, preset, least, most)
  if (!Number.isInteger(number)) throw new CallError('call.wholeNumber', { name, text: text ?? '' })
  return number
}

/** One of some names; the first where none is given. */
export function oneOf<Name extends string>(
  name: string,
  text: string | undefined,
  names: readonly Name[],
): Name {
  const found = text === undefined ? names[0] : names.find((one) => one === text)
  if (found === undefined) throw new CallError('call.oneOf', { name, names: listed(names), text: text ?? '' })
  return found
}

const listed = (names: readonly string[]) =>
  names.reduce((first, last) => message('call.or', { first, last }))

/** The rest of a call, and the language that it asks for. It is heard first: a faulty call too is answered in it. */
export function languageIn(args: readonly string[]) {
  const at = args.findIndex((arg) => arg === '--lang' || arg.startsWith('--lang='))
  if (at < 0) return { rest: args }
  const alone = args[at] === '--lang'
  const lang = alone ? args[at + 1] : args[at]!.slice('--lang='.length)
  return { lang: lang ?? '', rest: args.toSpliced(at, alone ? 2 : 1) }
}

/** @throws CallError for what is no language */
export function languageNamed(lang: string): Language {
  if (lang === '') throw new CallError('call.needsValue', { option: '--lang' })
  return oneOf('lang', lang, languages)
}

/** `de,en`: each once. @throws CallError for what is no language */
export const languagesNamed = (lang: string): readonly Language[] => [
  ...new Set(lang.split(',').map(languageNamed)),
]
