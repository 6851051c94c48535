#!/usr/bin/env node
import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/later'
import { learning } from '@botgarten/blocks/learning'
import { cards } from './cards.ts'
import { convert } from './convert.ts'
import { CallError, FileError } from './errors.ts'
import { learn } from './learn.ts'
import { run } from './run.ts'

// No screen waits for a smaller first part here.
addBlocks(expert)
addBlocks(learning)

const verbs: { readonly [name: string]: (args: string[]) => string | Promise<string> } = {
  run,
  cards,
  learn,
  convert,
  // Asked for late: it alone needs a browser.
  print: async (args) => (await import('./print/print.ts')).print(args),
}

const usage = `botgarten run FILE|CARD [--solution|--wrong N] [--weights FILE] [--start N] [--seconds N] [--seed N] [--json] | botgarten cards [--json] | botgarten convert IN.xml|IN.json OUT.xml|OUT.json [--robot ID] [--json] | botgarten print ITEM|all [--lang de|en] [--paper a4|a5] [--turn short|long] [--out DIR] [--address URL] [--json] | botgarten learn q --map M|FILE.svg --start A --goal B [--closed 3-2,2-3] [--rules standard|study] [--algorithm q|sarsa] [--alpha --gamma --nu --rho] [--alpha-decay --rho-decay] [--episodes N] [--time MOVES] [--seed N] [--json] | botgarten learn q-sweep … [--runs N] [--csv FILE] [--shard I/N] [--threads N] | botgarten learn q-thesis [--runs N] [--csv FILE] [--shard I/N] | botgarten learn kmeans --data FILE.csv --k K [--init FILE|random|++] [--distance euclidean|manhattan|cosine] [--starts N] [--seed N] [--decimal-comma] [--json]`

/** Carries one call out. Exit 0: it ran · 1: a file is at fault · 2: the call is at fault. */
async function main([verb = '', ...args]: string[]): Promise<number> {
  try {
    const carryOut = Object.hasOwn(verbs, verb) ? verbs[verb] : undefined
    if (!carryOut) throw new CallError(usage)
    process.stdout.write((await carryOut(args)) + '\n')
    return 0
  } catch (error) {
    if (!(error instanceof CallError || error instanceof FileError)) throw error
    process.stderr.write(`botgarten: ${error.message.replaceAll('\n', ' ')}\n`)
    return error instanceof CallError ? 2 : 1
  }
}

process.exitCode = await main(process.argv.slice(2))
