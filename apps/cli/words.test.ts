import { afterAll, describe, expect, it } from 'vitest'
import type { ProjectReason } from '@botgarten/programs'
import { commands, type Commands } from './commands.ts'
import { helpOf, listOf } from './help.ts'
import { languages, problemMessage, speak } from './words.ts'

/** Every command and group of commands with the words that lead there. */
const all = (some: Commands, path: readonly string[] = []): [string[], Commands[string]][] => [
  [[...path], some],
  ...Object.entries(some).flatMap(([name, found]): [string[], Commands[string]][] =>
    typeof found === 'function' ? [[[...path, name], found]] : all(found, [...path, name]),
  ),
]

const reasons: { readonly [reason in ProjectReason]: true } = {
  ...{ notJson: true, tooBig: true, notAProject: true, newerVersion: true },
  ...{ notACard: true, newerCard: true, cardTags: true },
  ...{ cardCheck: true, cardNumbers: true, cardWords: true },
  ...{ sceneNotJson: true, notAScene: true, isAProject: true, tooManyThings: true },
  ...{
    notXml: true,
    unsafeXml: true,
    notOpenRoberta: true,
    otherRobot: true,
    tooManyBlocks: true,
    tooDeep: true,
  },
}

afterAll(() => speak('en'))

describe.each(languages)('in %s', (language) => {
  it.each(all(commands).map(([path, found]) => [path.join(' '), path, found] as const))(
    'botgarten %s --help has words for all of it',
    async (_, path, found) => {
      speak(language)
      const help = typeof found === 'function' ? helpOf(path, await found()) : listOf(path, found)
      expect(help.split('\n')[0]).toMatch(new RegExp(`^botgarten ${path.join(' ')}`))
      for (const line of help.split('\n').slice(3)) expect(line).toMatch(/^ {2}(--|botgarten )\S.* {2}\S/)
    },
  )

  it('every reason to refuse a file is a sentence', () => {
    speak(language)
    for (const reason of Object.keys(reasons)) expect(problemMessage(reason)).toMatch(/ .*\.$/)
  })
})
