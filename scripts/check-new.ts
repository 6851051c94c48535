// `npm run check:new -- card caution`: the tests that a new member of a folder has to pass, without those of all others.
// CONTRIBUTING.md says for each kind what to add. `npm test` runs everything.
import { globSync, mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, relative } from 'node:path'
import { content } from '@botgarten/content/files'
import { sharesIn } from '@botgarten/messages/check'
import { house, inHouse } from './prepare/house.mjs'
import { asScript, run, Trouble } from './prepare/run.mjs'

/** The checks of one kind of member. */
interface Kind {
  /** Absolute pattern of the file that every member has. */
  readonly member: (name: string) => string
  readonly tests: readonly string[]
  /** Titles of the tests that are about this member, as a regular expression; all tests where there is none. */
  readonly titles?: (name: string) => string
}

const inContent = (...files: readonly string[]) =>
  files.map((file) => `packages/content/contract/${file}.test.ts`)

export const kinds: { readonly [kind: string]: Kind } = {
  block: {
    member: (type) => inHouse(`packages/blocks/*/${type}.ts`),
    tests: ['packages/blocks', 'packages/programs/examples.test.ts', 'packages/programs/run/twin.test.ts'],
    titles: (type) => `${type}|^the (folders|toolbox|words)|^random programs`,
  },
  card: {
    member: (id) => content.path('cards', `*/*-${id}/card.json`),
    tests: inContent('cards', 'items', 'names', 'given-blocks'),
    titles: (id) => `the card ${id} |the printed set|the alignment|every card is called`,
  },
  map: {
    member: (id) => content.path('maps', id, 'map.svg'),
    tests: [...inContent('names'), 'packages/maps/maps.test.ts', 'packages/maps/driving.test.ts'],
  },
  pane: {
    member: (feature) => inHouse(`apps/web/src/features/${feature}/feature.ts`),
    tests: ['apps/web/src/app/features.test.ts', 'packages/messages/contract.test.ts'],
    titles: (feature) => `^${feature} |that ${feature} says|part of ${feature} |language|facts|message`,
  },
  language: {
    member: (language) => content.path('words', language, '*.json'),
    tests: ['packages/messages/contract.test.ts'],
  },
}

/** Arguments of Vitest for one member. @throws Trouble for a kind or a member that does not exist */
export function testsOf(kind: string, name: string): readonly string[] {
  const found = Object.hasOwn(kinds, kind) ? kinds[kind] : undefined
  if (!found || !name) throw new Trouble(`Usage: npm run check:new -- ${Object.keys(kinds).join('|')} NAME`)
  if (globSync(found.member(name)).length === 0)
    throw new Trouble(
      `There is no ${kind} called "${name}": ${relative(house, found.member(name))} does not exist.`,
    )
  return [...found.tests, ...(found.titles ? ['--testNamePattern', found.titles(name)] : [])]
}

/** @throws Trouble where no test was about the member: the titles in `kinds` are out of date then */
async function runTests(tests: readonly string[]): Promise<number> {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-check-'))
  try {
    const report = join(folder, 'report.json')
    const reporters = ['--reporter=default', '--reporter=json', `--outputFile=${report}`]
    const vitest = inHouse('node_modules/vitest/vitest.mjs')
    const code = await run(process.execPath, [vitest, 'run', ...reporters, ...tests])
    const { numPassedTests } = JSON.parse(readFileSync(report, 'utf8')) as { numPassedTests: number }
    if (code === 0 && numPassedTests === 0)
      throw new Trouble('No test is about it: scripts/check-new.ts is wrong.')
    return code
  } finally {
    rmSync(folder, { recursive: true, force: true })
  }
}

if (import.meta.main)
  await asScript(async () => {
    const [kind = '', name = ''] = process.argv.slice(2)
    const code = await runTests(testsOf(kind, name))
    if (kind === 'language') console.log(sharesIn().join('\n'))
    return code
  })
