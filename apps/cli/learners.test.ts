import { learnerFolders, learnerIn, withoutCommand } from '@botgarten/learning/testing'
import { expect, it } from 'vitest'
import { commands } from './commands.ts'

it('every way of learning has its command: botgarten learn <name>', async () => {
  const all = await Promise.all(learnerFolders().map(learnerIn))
  const names = all.map(({ learner }) => learner.name)
  expect(names).toContain('q')
  expect(withoutCommand(names, commands['learn']!)).toEqual([])
})
