#!/usr/bin/env node
import { cards } from './cards.ts'
import { CallError, FileError } from './errors.ts'
import { run } from './run.ts'

const verbs: { readonly [name: string]: (args: string[]) => string } = { run, cards }

const usage = `botgarten run FILE|CARD [--solution|--wrong N] [--weights FILE] [--start N] [--seconds N] [--seed N] [--json] | botgarten cards [--json]`

/** Carries one call out. Exit 0: it ran · 1: a file is at fault · 2: the call is at fault. */
function main([verb = '', ...args]: string[]): number {
  try {
    const carryOut = Object.hasOwn(verbs, verb) ? verbs[verb] : undefined
    if (!carryOut) throw new CallError(usage)
    process.stdout.write(carryOut(args) + '\n')
    return 0
  } catch (error) {
    if (!(error instanceof CallError || error instanceof FileError)) throw error
    process.stderr.write(`botgarten: ${error.message.replaceAll('\n', ' ')}\n`)
    return error instanceof CallError ? 2 : 1
  }
}

process.exitCode = main(process.argv.slice(2))
