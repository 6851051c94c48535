import { expect } from '@playwright/test'
import type { Child } from './child.ts'
import { GalleryHands, sharesOne } from './child-gallery.ts'
import { joins, saves, signsIn, teaches, type MadeClass } from './made-class.ts'
import type { ClassScreen } from './screens-class.ts'

/** A class that has shared a few things, and a child that looks at them. */
async function fillsGallery({ page }: Child, made: MadeClass) {
  const makers = [
    ['Luna', 'Rally, fast one', 'solution'],
    ['Otter', 'Shy Bo', 'start'],
    ['Nova', 'Disco leaves in the garden of a long title', 'solution'],
  ] as const
  const kestrel = await joins(made, 'Kestrel')
  let from: readonly { readonly id: string; readonly title: string }[] = []
  for (const [nickname, title, program] of makers) {
    const maker = await joins(made, nickname)
    const id = await sharesOne(maker, title, { program, more: { madeFrom: from } })
    from = [...from, { id, title }]
    await kestrel.asker.ask('PUT', `/gallery/${id}/heart`, { on: title !== 'Shy Bo' })
  }
  await sharesOne(kestrel, 'My maze')
  await saves(kestrel)
  await signsIn(page, made, kestrel)
}

const opens = async (child: Child, made: MadeClass) => {
  await fillsGallery(child, made)
  const gallery = new GalleryHands(child)
  await gallery.opens()
  await expect(gallery.titles).toHaveCount(4)
  return gallery
}

const looks = async (child: Child, made: MadeClass) => {
  const gallery = await opens(child, made)
  await gallery.looks('Disco leaves in the garden of a long title')
  return gallery
}

/** The gallery of a class, for pupils and for the teacher. */
export const galleryScreens: readonly ClassScreen[] = [
  { name: 'gallery', show: async (child, made) => void (await opens(child, made)) },
  { name: 'gallery-look', show: async (child, made) => void (await looks(child, made)) },
  {
    name: 'gallery-brain',
    async show(child, made) {
      await looks(child, made)
      await child.presses('gallery.takeBrain')
      await expect(child.page.getByRole('radio').first()).toBeAttached()
    },
  },
  {
    name: 'gallery-share',
    async show(child, made) {
      await opens(child, made)
      await child.presses('gallery.shareOne')
      await child.page.getByRole('dialog').getByRole('radio').first().check({ force: true })
    },
  },
  {
    name: 'class-gallery',
    async show(child, made) {
      await fillsGallery(child, made)
      await teaches(child.page, made)
      await child.page.goto(`/teacher?class=${made.id}&view=gallery`)
      await expect(child.page.locator('article h2')).toHaveCount(4)
    },
  },
]
