import type { ObjectSchema, ParameterSchema } from '../parameters.ts'

const share: ParameterSchema = { type: 'number', minimum: 0, maximum: 1 }

const decay = (kind: string, properties: ObjectSchema['properties'] = {}): ObjectSchema => ({
  type: 'object',
  properties: { kind: { enum: [kind] }, ...properties },
  required: ['kind', ...Object.keys(properties)],
  additionalProperties: false,
})
const decays = [decay('constant'), decay('episodes', { factor: share })]

/** What `Settings` may be. Only α falls with visits. */
export const parameters: ObjectSchema = {
  type: 'object',
  properties: {
    rules: { enum: ['standard', 'study'] },
    algorithm: { enum: ['q', 'sarsa'] },
    ...{ alpha: share, gamma: share, nu: share, rho: share },
    alphaDecay: { oneOf: [...decays, decay('visits')] },
    rhoDecay: { oneOf: decays },
  },
  required: ['rules', 'algorithm', 'alpha', 'gamma', 'nu', 'rho'],
  additionalProperties: false,
}
