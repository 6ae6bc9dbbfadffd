// Stored models: /v1/models/ID. Who made one keeps its secret and can take it back.
import { days, kLimits } from './limits.mjs';
import { Refusal } from './refusal.mjs';
import { isSame } from './secrets.mjs';

export function modelRoutes(app, { store, clock, limits, idOf, needSecret, bytesOf, sendBytes }) {
  const limit = { config: { rateLimit: { ...kLimits.models, ...limits.models } }, bodyLimit: kLimits.modelBytes };

  // Again with the same bytes and secret it changes nothing: an answer that was lost is asked for again.
  app.put('/v1/models/:id', limit, async (request, reply) => {
    const id = idOf(request.params.id);
    const owner = needSecret(request);
    const kept = Number(request.query.days ?? kLimits.modelDays.at(-1));
    if (!kLimits.modelDays.includes(kept)) throw new Refusal('BadRequest');
    const bytes = bytesOf(request);
    const now = clock.now();
    const result = await store.putModel({ id, owner, expires: now + days(kept), bytes }, now);
    if (result === 'taken') throw new Refusal('Taken');
    return reply.code(result === 'made' ? 201 : 200).send({ days: kept });
  });

  app.get('/v1/models/:id', async (request, reply) => {
    const id = idOf(request.params.id);
    const box = await store.box(id, clock.now());
    const post = box?.kind === 'model' ? await store.post(id, 'model') : null;
    if (!post) throw new Refusal('NotThere');
    return sendBytes(reply, post.bytes);
  });

  app.delete('/v1/models/:id', async (request, reply) => {
    const id = idOf(request.params.id);
    const owner = needSecret(request);
    const box = await store.box(id, clock.now());
    if (box?.kind !== 'model') throw new Refusal('NotThere');
    if (!isSame(box.owner, owner)) throw new Refusal('WrongSecret');
    await store.removeBox(id);
    return reply.code(204).send();
  });
}
