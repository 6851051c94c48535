import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { content } from '@botgarten/content/files'
import { differencesOf, projectFrom } from '@botgarten/programs/open-roberta'
import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { message } from '#words/message.ts'
import { wordsOfDifferences } from './findings.ts'

addBlocks(expert)

const programs = new URL('../../../../../packages/programs/testing/open-roberta/programs/', import.meta.url)

test('a file whose program may end here but not in Open Roberta is explained, with a way to the block', () => {
  const text = readFileSync(new URL('composed__common__listOperationsBasic.xml', programs), 'utf8')
  const project = projectFrom(text, 'Lists', content.world('garden')!)
  const [robot] = project.world.robots
  const program = project.programs[robot!.program]!
  const differences = differencesOf(program, robot!.config)
  const shown: string[] = []
  const { title, text: said, fixes } = wordsOfDifferences(differences, (block) => shown.push(block))
  expect(title).toBe(message('openRoberta.ends.title'))
  expect(said).toContain(message('openRoberta.ends.place'))
  fixes.find(({ label }) => label === message('openRoberta.ends.show.place'))!.fix()
  const block = `"id":"${shown[0]}","type":"robLists_setIndex"`
  expect(JSON.stringify(program.stacks).includes(block)).toBe(true)
})
