import { expect } from '@playwright/test'
import { fills, teaches } from './made-class.ts'
import type { ClassScreen } from './screens-class.ts'

const wall = [{ width: 1920, height: 1080 }]

/** What a class sees on the wall. */
export const projector: readonly ClassScreen[] = [
  {
    name: 'class-projector',
    more: wall,
    async show(child, made) {
      await fills(made, 19)
      await teaches(child.page, made)
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await expect(child.page.locator('.joined b')).toHaveText('19')
    },
  },
  {
    name: 'class-projector-wifi',
    more: wall,
    async show(child, made) {
      await fills(made, 19)
      const wifi = { name: 'Botgarten', password: 'sonnenblume-26' }
      await made.teacher.ask('PUT', `/classes/${made.id}/wifi`, wifi)
      await teaches(child.page, made)
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await expect(child.page.getByText('sonnenblume-26')).toBeVisible()
    },
  },
  {
    name: 'class-wifi',
    async show(child, made) {
      await teaches(child.page, made)
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await child.presses('teacher.wifi')
      await expect(child.page.getByRole('dialog')).toBeVisible()
    },
  },
  {
    name: 'class-projector-closed',
    more: wall,
    async show(child, made) {
      await made.teacher.ask('POST', `/classes/${made.id}/close`)
      await teaches(child.page, made)
      await child.page.goto(`/teacher/projector?class=${made.id}`)
      await expect(child.words('teacher.projectorClosed')).toBeVisible()
    },
  },
]
