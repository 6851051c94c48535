import type { Examination } from '@botgarten/server/doctor'
import type { Command } from './commands.ts'
import { options, refuseMore, wholeNumberIn } from './options.ts'
import { usualData, usualPort } from './serve.ts'
import { message } from './words.ts'

const known = {
  port: { type: 'string' },
  host: { type: 'string' },
  data: { type: 'string' },
  json: { type: 'boolean' },
} as const

/** `botgarten doctor`: what keeps a class server from running here, and what to do. Changes nothing. Exit 1: something does. */
export const doctor: Command = { options: known, execute: look }

async function look(args: string[]): Promise<string> {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  const port = wholeNumberIn('port', values.port, usualPort, 1, 65_535)
  const { examine } = await import('@botgarten/server/doctor')
  const findings = await examine({ port, host: values.host, data: values.data ?? usualData })
  const toDo = findings.filter(({ fine }) => !fine).length
  if (toDo > 0) process.exitCode = 1
  if (values.json) return JSON.stringify({ ok: toDo === 0, findings: findings.map(asJson) })
  const verdict = toDo === 0 ? message('doctor.allFine') : message('doctor.toDo', { count: toDo })
  return [
    ...findings.map((finding) => `${finding.fine ? '✓' : '!'} ${sentenceOf(finding)}`),
    '',
    verdict,
  ].join('\n')
}

const sentenceOf = ({ verdict, facts }: Examination[number]) => message(`doctor.${verdict}`, facts)

/** Schema: schemas/doctor.json. */
const asJson = (finding: Examination[number]) => {
  const [about, verdict] = finding.verdict.split('.')
  return { about, verdict, fine: finding.fine, facts: finding.facts, says: sentenceOf(finding) }
}
