// Rooms: app
// By address: the first load of a page.
import { expect, test } from '../house.ts'

for (const path of ['/', '/lab/friendship']) {
  test(`${path} asks no other host, breaks no policy and logs no error`, async ({ page, house }) => {
    const asked: string[] = []
    const errors: string[] = []
    page.on('request', (request) => asked.push(request.url()))
    page.on('console', (message) => message.type() === 'error' && errors.push(message.text()))
    page.on('pageerror', (error) => errors.push(error.message))
    await page.goto(path, { waitUntil: 'networkidle' })
    await expect(page.getByRole('heading').first()).toBeVisible()
    expect(asked.filter((url) => /^https?:/.test(url) && !url.startsWith(`${house}/`))).toEqual([])
    expect(errors).toEqual([])
  })
}
