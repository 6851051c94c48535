import { globSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { formsOf } from '@botgarten/messages'
import { filesIn, ownTableOf } from '@botgarten/messages/folder'
import { expect, test } from 'vitest'

const root = join(import.meta.dirname, '../../../content')

/**
 * A star is the value of a move, from none to five. A reward is called reward, and drawn as a coin. Only these texts may
 * name stars; each is about values of moves or doors, unless another reason is given.
 */
const aboutValues = [
  ...['cards/q-learning/01-railway', 'materials/sheet/03-q-questions', 'materials/sheet/04-q-map'],
  ...['materials/kit/06-floor-map', 'materials/slides/03-learn-from-experience'],
  ...['materials/plan/04-learning-from-experience', 'materials/plan/05-you-or-bo'],
  ...['materials/plan/20-lesson-race', 'materials/worksheet/47-exit-race'],
  'materials/solution/14-answers-lesson-4',
]
const keysAboutValues = [
  ...['q.stars', 'q.said.move', 'q.why.stars', 'q.more', 'q.less', 'materials.q.learn'],
  ...['race.notesText', 'race.noteOf', 'race.stars'],
]
/** A picture of a secret is a star, and a starling is "Star" in German. */
const pictures = /^(class|teacher)\..*\.star$|^form\.bird\.starling$/

const star = /\bstars?\b|\bstern(e|en|s|chen)?\b|★/i
/** A reward is large, or it is paid at a place. */
const ofReward =
  /(?:[6-9]|\d\d+) (?:stars|sterne)\b(?! aus papier)|fountain|brunnen|\bschool\b|\bschule\b|\bbin\b|tonne|\bball\b|\bpa(?:y|ys|id)\b|\bzahlt\b|bezahl|reward|belohnung/i

/** Without lines that include other content by its id. */
const sentences = (text: string) => text.split(/(?<=[.!?:])\s|\n|\|/).filter((one) => !one.startsWith('::'))
const texts = globSync('**/*.md', { cwd: root }).toSorted()
const messages = ['en', 'de'].flatMap((language) =>
  filesIn().flatMap((file) =>
    Object.entries(ownTableOf(file, language)).map(([key, message]) => ({
      key,
      name: `${language} ${key}`,
      // Names of facts are no words.
      text: formsOf(message)
        .join('\n')
        .replaceAll(/\{\w+\}/g, ''),
    })),
  ),
)

test('no text names stars but those about the value of a move', () => {
  const named = texts.filter((path) => star.test(readFileSync(join(root, path), 'utf8')))
  expect(named.filter((path) => !aboutValues.some((folder) => path.startsWith(`${folder}/`)))).toEqual([])
  const unused = aboutValues.filter((folder) => !named.some((path) => path.startsWith(`${folder}/`)))
  expect(unused).toEqual([])
})

test('no message names stars but those about the value of a move', () => {
  const named = messages.filter(({ text }) => star.test(text))
  const wrong = named.filter(({ key }) => !keysAboutValues.includes(key) && !pictures.test(key))
  // Scripts pass this option value of a race to the command line.
  expect(
    wrong.map(({ name, text }) => `${name}: ${text}`).filter((one) => !one.endsWith(': way|stars|falls')),
  ).toEqual([])
  expect(keysAboutValues.filter((key) => !named.some((one) => one.key === key))).toEqual([])
})

test('no sentence about stars speaks of a reward', () => {
  const all = [
    ...texts.map((path) => ({ name: path, text: readFileSync(join(root, path), 'utf8') })),
    ...messages.filter(({ key }) => !pictures.test(key)),
  ]
  const wrong = all.flatMap(({ name, text }) =>
    sentences(text)
      .filter((one) => star.test(one) && ofReward.test(one))
      .map((one) => `${name}: ${one}`),
  )
  expect(wrong).toEqual([])
})
