// Rooms: materials, q-learning
import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { explainedPlaces, showsExplained } from '../explained-lab.ts'
import { placesIn } from '../explained-picture.ts'
import { expect, test } from '../house.ts'
import { languages } from '../words.ts'

/** An arrow that is so many px beside its place still points to it. */
const slack = 12

for (const language of languages)
  test.describe(`sheet 4.3 in ${language}`, () => {
    test.use({ language })

    test('its arrows point to where things are on the screen: `npm run explain` draws them again', async ({
      child,
    }) => {
      const picture = content.path(content.itemFolder('q-map'), `screen-${language}.svg`)
      const drawn = placesIn(readFileSync(picture, 'utf8'))
      await showsExplained(child)
      const now = await explainedPlaces(child)
      expect(drawn).toHaveLength(now.length)
      const away = now.map(({ x, y }, at) => Math.hypot(x - drawn[at]![0], y - drawn[at]![1]))
      expect(Math.max(...away)).toBeLessThan(slack)
    })
  })
