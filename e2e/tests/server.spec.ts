// Rooms: server
// By address: the subject is the server's answer to an address.
import { classOfTest } from '../class-server.ts'
import { expect, test } from '../house.ts'

/** A policy as its directives and what each allows. */
const directivesOf = (policy = ''): { readonly [directive: string]: readonly string[] } =>
  Object.fromEntries(
    policy.split(/;\s*/).map((part) => {
      const [directive = '', ...allowed] = part.split(' ')
      return [directive, allowed]
    }),
  )

/** What every answer promises, whatever it answers. */
function expectGuarded(headers: { [name: string]: string }) {
  const policy = directivesOf(headers['content-security-policy'])
  expect(policy['frame-ancestors']).toEqual(["'self'"])
  expect(policy['object-src']).toEqual(["'none'"])
  expect(policy['base-uri']).toEqual(["'none'"])
  expect(headers['x-content-type-options']).toBe('nosniff')
  expect(headers['referrer-policy']).toBe('same-origin')
  expect(headers['permissions-policy']).toMatch(/\bcamera=\(\).*\bmicrophone=\(\)/)
}

for (const path of ['/', '/lab/friendship', '/lab/fear']) {
  test(`the page ${path} is served with the policy of the architecture, its script by hash`, async ({
    request,
  }) => {
    const answer = await request.get(path)
    expect(answer.status()).toBe(200)
    expectGuarded(answer.headers())
    const policy = directivesOf(answer.headers()['content-security-policy'])
    expect(policy['script-src']).toEqual(["'self'", expect.stringMatching(/^'sha256-/)])
    expect(policy['connect-src']).toEqual(["'self'"])
    expect(policy['default-src']).toEqual(["'self'"])
    expect(await answer.text()).toContain('http-equiv="content-security-policy"')
  })
}

test('the browser knows every feature that the server switches off', async ({ page }) => {
  const complaints: string[] = []
  page.on('console', (message) => {
    if (/permissions-policy/i.test(message.text())) complaints.push(message.text())
  })
  await page.goto('/lab/fear')
  await expect(page.getByRole('heading', { level: 1 })).toBeVisible()
  expect(complaints).toEqual([])
})

test("no page that opened a teacher's has a hold on its window", async ({ request }) => {
  const alone = async (path: string) => (await request.get(path)).headers()['cross-origin-opener-policy']
  expect(await alone('/teacher')).toBe('same-origin')
  expect(await alone('/lab/fear')).toBeUndefined()
})

test('an unknown address answers 404 as a page, guarded like the others', async ({ request }) => {
  const answer = await request.get('/no/such/page')
  expect(answer.status()).toBe(404)
  expect(answer.headers()['content-type']).toContain('text/html')
  expectGuarded(answer.headers())
  expect(directivesOf(answer.headers()['content-security-policy'])['script-src']).toContain("'self'")
})

test.describe('an address of no card and no item', () => {
  test.use({ complaints: [/404/] })

  for (const path of ['/lab/nothing', '/materials/sheet/nothing'])
    test(`${path} answers 404, with the page that says so to a child`, async ({ child, page }) => {
      const answer = await page.goto(path)
      expect(answer!.status()).toBe(404)
      expectGuarded(await answer!.allHeaders())
      await expect(
        page.getByRole('heading', {
          name: child.word(path.startsWith('/lab') ? 'lab.unknownCardTitle' : 'parts.lostTitle'),
        }),
      ).toBeVisible()
    })
})

test('a broken address is refused and does not end the server', async ({ request }) => {
  const answer = await request.get('/%E0%A4%A')
  expect(answer.status()).toBe(400)
  expectGuarded(answer.headers())
  expect((await request.get('/')).status()).toBe(200)
})

test('what has a hash in its name is kept for a year and comes as brotli, pages are asked for again', async ({
  request,
}) => {
  const page = await request.get('/')
  const script = /_app\/immutable\/entry\/start\.[\w-]+\.js/.exec(await page.text())?.[0]
  const answer = await request.get(`/${script}`, { headers: { 'accept-encoding': 'br' } })
  expect(answer.status()).toBe(200)
  expect(answer.headers()['cache-control']).toBe('public,max-age=31536000,immutable')
  expect(answer.headers()['content-encoding']).toBe('br')
  expect(page.headers()['cache-control']).toBe('no-cache')
  expectGuarded(answer.headers())
})

test.describe('a page that somebody tampers with', () => {
  // The refusal is what the test asks for.
  test.use({ complaints: [/Content Security Policy/] })

  test('inline script is refused by the policy', async ({ page }) => {
    await page.goto('/')
    const refused = page.evaluate(
      () =>
        new Promise<string>((done) =>
          document.addEventListener('securitypolicyviolation', (event) => done(event.effectiveDirective)),
        ),
    )
    await page.evaluate(() => {
      const script = document.createElement('script')
      script.textContent = 'document.title = "taken over"'
      document.body.append(script)
    })
    expect(await refused).toBe('script-src-elem')
    await expect.poll(() => page.title()).not.toBe('taken over')
  })
})

test('the class answers at the address of the lab, guarded like its pages, and knows who asks', async ({
  request,
}) => {
  const open = await classOfTest()
  const { asker } = await open.pupil('Fuchs')
  const { body } = await asker.ask('GET', '/state')
  expect(body).toMatchObject({ firstTeacher: { name: null }, pupil: { nickname: 'Fuchs' } })
  const answer = await request.get(`${open.url}/api/class/state`)
  expectGuarded(answer.headers())
  expect(answer.headers()['cache-control']).toBe('no-store')
  await open.close()
})
