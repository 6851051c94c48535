import content from 'content:questionnaires'
import { readFormFile, writeFormFile } from '@botgarten/content/questionnaires'
import { expect, test } from 'vitest'
import { Changing } from './changing.svelte.ts'

const after = content.forms.find(({ form }) => form.id === 'after')!
const steps = ['nein', 'eher nein', 'geht so', 'eher ja', 'ja']

test('a changed form is a form of its own in one language', () => {
  const changing = new Changing(after, 'de', after.text['de']!)
  changing.title = 'Nach dem Projekttag'
  changing.asked['interest-unsupervised'] = false
  changing.asked['ease-unsupervised'] = false
  changing.questions['go-on'] = 'Machst du weiter?'
  expect(changing.isReady).toBe(true)
  changing.add('scale')
  expect(changing.isReady).toBe(false)
  changing.questions['own-1'] = 'War es lustig?'
  const made = changing.made('after-2', steps)
  expect(readFormFile(JSON.parse(writeFormFile(made)))).toEqual(made)
  expect(made.form.items.map(({ id }) => id)).not.toContain('ease-unsupervised')
  expect(made.form.screens).toHaveLength(6)
  expect(made.form.screens.at(-1)).toEqual(['own-1'])
  expect(made.text['de']!.words['go-on']).toEqual({
    question: 'Machst du weiter?',
    yes: 'Ja',
    maybe: 'Vielleicht',
    no: 'Nein',
  })
  expect(made.text['de']!.words['own-scale']).toMatchObject({ '5': 'ja' })
})

test('a form of one’s own keeps its name when it is changed again', () => {
  const made = new Changing(after, 'de', after.text['de']!).made('after-2', steps)
  const again = new Changing(made, 'de', made.text['de']!).made('after-3', steps)
  expect(again.form.id).toBe('after-2')
})

test('a form in another language only has the words of that language where nothing was changed', () => {
  const words = after.text['de']!
  const french = { form: { ...after.form, id: 'after-2' }, text: { fr: words } }
  const made = new Changing(french, 'en', words).made('after-3', steps)
  expect(made.text['en']!.words['go-on']).toEqual(words.words['go-on'])
})
