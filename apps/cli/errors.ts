import { parseArgs, type ParseArgsConfig } from 'node:util'

/** The call itself is wrong: exit 2. */
export class CallError extends Error {}

/** A file is missing or wrong: exit 1. */
export class FileError extends Error {}

/** Reads options; what is unknown or has no value is the call's fault. */
export function options<const Options extends NonNullable<ParseArgsConfig['options']>>(
  args: string[],
  known: Options,
) {
  try {
    return parseArgs({ args, options: known, allowPositionals: true })
  } catch (error) {
    throw new CallError((error as Error).message)
  }
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
    throw new CallError(`--${name} takes a number from ${least} to ${most}, not "${text}".`)
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
  if (!Number.isInteger(number)) throw new CallError(`--${name} takes a whole number, not "${text}".`)
  return number
}
