// `npm run python -- FOLDER`: every card's solution and every given file of Open Roberta as Python, for check.py.
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { addBlocks, knowMaps } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardDocument } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { learnedFor } from '@botgarten/maps'
import { fill } from '@botgarten/messages'
import { wordsOf } from '@botgarten/messages/folder'
import type { Project } from '@botgarten/programs'
import { projectFrom } from '@botgarten/programs/open-roberta'
import { dialects, pythonFrom } from '@botgarten/programs/python'
import { givenNames, readGiven } from './given.ts'

addBlocks(expert)
addBlocks(learning)
knowMaps(content)

type Document = Pick<Project, 'programs' | 'world' | 'brains'>

const cards = content.cards.map(({ id }): readonly [string, Document] => {
  const { card, world } = content.card(id)!
  return [`card-${id}`, cardDocument(world, card, content.program(id, 'solution')!, 0)]
})
const given = givenNames().flatMap((name): readonly (readonly [string, Document])[] => {
  try {
    return [[name, projectFrom(readGiven(name), name, content.freeLab().world)]]
  } catch {
    // Some of the given files are for other robots, or empty.
    return []
  }
})

const [, , folder = ''] = process.argv
mkdirSync(folder, { recursive: true })
for (const [name, document] of [...cards, ...given])
  for (const dialect of dialects)
    for (const language of ['de', 'en']) {
      const words = wordsOf(language)
      const say = (key: string, facts = {}) => (words[key] ? fill(words[key], facts, language) : key)
      const [robot] = document.world.robots
      const program = document.programs[robot!.program]!
      const learned = learnedFor(program, (id) => content.mapFile(id))
      const input = { name, program, config: robot!.config, brains: document.brains, dialect, learned }
      writeFileSync(join(folder, `${name}.${dialect}.${language}.py`), pythonFrom(input, say).text)
      const learner = learned.lesson && pythonFrom({ ...input, learner: true }, say).text
      if (learner) writeFileSync(join(folder, `${name}-learner.${dialect}.${language}.py`), learner)
    }
