import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { botgarten } from './testing.ts'

let data: string
beforeEach(() => void (data = mkdtempSync(join(tmpdir(), 'botgarten-doctor-'))))
afterEach(() => {
  rmSync(data, { recursive: true, force: true })
  process.exitCode = undefined
})

const schema = readFileSync(join(import.meta.dirname, 'schemas/doctor.json'), 'utf8')

async function portOfAnother() {
  const other = createServer((_, response) => void response.end('hello'))
  await new Promise<void>((done) => other.listen(0, done))
  return { other, port: `${(other.address() as AddressInfo).port}` }
}

test('what is wrong is said as a sentence in either language, and as one line of JSON', async () => {
  const { other, port } = await portOfAnother()
  const call = ['doctor', '--port', port, '--data', join(data, 'Übung 5b')]
  const { stdout } = await botgarten(...call)
  expect(stdout).toContain(`! Port ${port} is taken by another program.`)
  expect(process.exitCode).toBe(1)
  expect((await botgarten(...call, '--lang', 'de')).stdout).toContain(
    `! Port ${port} benutzt ein anderes Programm.`,
  )
  const { json } = await botgarten(...call, '--json')
  const fits = new Ajv2020().compile(JSON.parse(schema) as object)
  fits(json())
  expect(fits.errors).toBeNull()
  expect(json()).toMatchObject({
    ok: false,
    findings: [{ about: 'port', verdict: 'taken' }, {}, {}, {}, {}, {}, {}],
  })
  other.close()
})

test.each([[['--port', '0']], [['--port', 'x']], [['now']]])('doctor %j is refused', async (args) =>
  expect((await botgarten('doctor', ...args)).status).toBe(2),
)
