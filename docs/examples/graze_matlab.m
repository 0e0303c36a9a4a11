function result = graze_matlab(scene, varargin)
%GRAZE_MATLAB  Graze from MATLAB, on the C interface. Untested: no MATLAB was at hand.
%   result = graze_matlab(fileread('scene.toml'), 'simulate', '--periods', '20');
%   result.json is the document, decoded; result.message a sentence where the numerics gave up.
%   Give the folders of libgraze.so and graze.h to loadlibrary where they are not in the usual places.
if ~libisloaded('libgraze')
    loadlibrary('libgraze.so', 'graze.h', 'alias', 'libgraze');
end
words = libpointer('stringPtrPtr', varargin);
run = calllib('libgraze', 'graze_run', scene, words, numel(varargin));
done = onCleanup(@() calllib('libgraze', 'graze_free', run));
result.message = calllib('libgraze', 'graze_message', run);
status = calllib('libgraze', 'graze_status', run);
if any(status == [2 4])
    error('graze:failed', '%s', result.message);
end
result.json = jsondecode(calllib('libgraze', 'graze_json', run));
end
