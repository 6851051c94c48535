import { expect } from '@playwright/test'
import type { Child } from './child.ts'
import { Pupil } from './child-class.ts'
import { joins, type Joined } from './made-class.ts'
import type { ClassScreen } from './screens-class.ts'

const all = ['tree', 'cup', 'boat', 'star', 'house', 'fish', 'leaf', 'key', 'sun', 'ball', 'flag', 'moon']
const wrong = (pupil: Joined) => all.filter((one) => !pupil.pictures.includes(one)).slice(0, 3)

const named = (child: Child, pictures: readonly string[]) =>
  pictures.map((one) => child.word(`class.picture.${one}`))

/** How somebody joins a class, or comes back to it. */
export const joining: readonly ClassScreen[] = [
  { name: 'join', show: (child, made) => new Pupil(child, made).opens(null) },
  {
    name: 'join-nickname',
    async show(child, made) {
      const newcomer = new Pupil(child, made)
      await newcomer.opens()
      await newcomer.nickname.fill('Fuchs')
    },
  },
  {
    name: 'join-wrong-code',
    async show(child, made) {
      const newcomer = new Pupil(child, made)
      await newcomer.opens('falsch immer kuchen garten')
      await newcomer.isRefused()
    },
  },
  {
    name: 'join-taken',
    async show(child, made) {
      await joins(made, 'Fuchs')
      const newcomer = new Pupil(child, made)
      await newcomer.opensByLink()
      await newcomer.nickname.fill('Fuchs')
      await child.presses('class.join')
      await newcomer.isRefused()
    },
  },
  {
    name: 'join-throttled',
    async show(child, made) {
      const newcomer = new Pupil(child, made)
      await newcomer.opens(null)
      await child.page.route('**/api/class/look', (route) =>
        route.fulfill({ status: 429, json: { error: 'tooManyTries', seconds: 130 } }),
      )
      for (const word of made.code.split(' ')) await child.page.keyboard.type(`${word} `)
      await newcomer.isRefused()
    },
  },
  {
    name: 'join-pictures',
    async show(child, made) {
      const newcomer = new Pupil(child, made)
      await newcomer.opensByLink()
      await newcomer.nickname.fill('Fuchs')
      await child.presses('class.join')
      await expect(child.button('class.remembered')).toBeVisible()
    },
  },
  {
    name: 'join-return',
    async show(child, made) {
      const { pictures, nickname } = await joins(made, 'Fuchs')
      const newcomer = new Pupil(child, made)
      await newcomer.opensByLink()
      await child.presses('class.wasThere')
      await newcomer.nickname.fill(nickname)
      await child.presses('class.next')
      await newcomer.taps(...named(child, pictures.slice(0, 2)))
    },
  },
  {
    name: 'join-return-wrong',
    async show(child, made) {
      const pupil = await joins(made, 'Fuchs')
      const newcomer = new Pupil(child, made)
      await newcomer.opensByLink()
      await child.presses('class.wasThere')
      await newcomer.nickname.fill(pupil.nickname)
      await child.presses('class.next')
      await newcomer.taps(...named(child, wrong(pupil)))
      await newcomer.isRefused()
    },
  },
]
