#!/usr/bin/env node
import { call } from './call.ts'

const { status, stdout, stderr } = await call(process.argv.slice(2))
process.stderr.write(stderr)
process.stdout.write(stdout)
// A red rehearsal has set it already.
if (status !== 0) process.exitCode = status
